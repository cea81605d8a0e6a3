// Sums over a cluster's samples. They are doubles: a sum over a million samples then keeps its
// digits and depends on nothing but which samples it has, so that splits come to rest.
struct UmbraSums {
  double weight, first, second;  // Σw, Σw·u, Σw·u² with u = x − ½
  float low, high;               // of the values with weight; low > high where there is none
};

const float umbraFarthest = 3.0e38;

UmbraSums umbraNoSums() {
  return UmbraSums(0.0lf, 0.0lf, 0.0lf, umbraFarthest, -umbraFarthest);
}
