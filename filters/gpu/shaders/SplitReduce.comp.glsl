// Adds up runs of a cluster's sums: this is one level of a pyramid whose last level has one sum a
// cluster.
layout(local_size_x = 32) in;

uniform int umbraCount;   // sums of each cluster in `umbraFine`
uniform int umbraCoarseCount;  // of each in `umbraCoarse`
uniform int umbraRun;  // how many sums become one
layout(std430, binding = 0) readonly buffer Fine {
  UmbraSums umbraFine[];
};
layout(std430, binding = 1) writeonly buffer Coarse {
  UmbraSums umbraCoarse[];
};

void main() {
  int own = int(gl_GlobalInvocationID.x);
  if (own >= umbraCoarseCount * UMBRA_CLUSTERS) return;
  int cluster = own / umbraCoarseCount;
  int begin = (own - cluster * umbraCoarseCount) * umbraRun;
  int end = min(begin + umbraRun, umbraCount);
  UmbraSums total = umbraNoSums();
  for (int i = begin; i < end; ++i) {
    UmbraSums sums = umbraFine[cluster * umbraCount + i];
    total.weight += sums.weight;
    total.first += sums.first;
    total.second += sums.second;
    total.low = min(total.low, sums.low);
    total.high = max(total.high, sums.high);
  }
  umbraCoarse[own] = total;
}
