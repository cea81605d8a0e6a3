// Box mean, minimum and maximum along one axis at a cost per texel that does not grow with the
// radius: van Herk's and Gil & Werman's method. A line is cut into blocks as long as the window;
// a window that starts inside a block is the end of that block and the beginning of the next.
// Sums go the same way: unlike a running sum nothing is ever subtracted, so that a large value
// leaves no rounding error in the windows after it.
// x: lines, y: blocks of a line, z: layers.
layout(local_size_x = 16, local_size_y = 2) in;

const int largestWindow = 129;

// A sum of large exponentials leaves the range of a float where their mean does not. Taps of means
// are therefore divided by a power of two first, `scale` in their channels, which rounds nothing.
vec4 umbraScaledTap(ivec2 texel, int layer, vec4 scale) {
  return umbraTap(texel, layer) * scale;
}

void main() {
  ivec2 size = textureSize(umbraSource, 0).xy;
  int window = 2 * umbraRadius + 1;
  int length = umbraAxis.x != 0 ? size.x : size.y;
  int lines = umbraAxis.x != 0 ? size.y : size.x;
  int line = int(gl_GlobalInvocationID.x), begin = int(gl_GlobalInvocationID.y) * window;
  int layer = int(gl_GlobalInvocationID.z);
  if (line >= lines || begin >= length) return;
  ivec2 first = begin * umbraAxis + line * umbraAxis.yx;  // the block's first texel
  ivec2 start = first - umbraRadius * umbraAxis;          // first tap of its first window

  float part = ldexp(1.0, -1 - findMSB(window - 1));
  vec4 scale = mix(vec4(1.0), vec4(part), equal(umbraSigns[layer % UMBRA_LAYERS], vec4(0.0)));
  vec4 ends[largestWindow];  // ends[i]: taps i … window-1 combined
  vec4 value = umbraScaledTap(start + (window - 1) * umbraAxis, layer, scale);
  ends[window - 1] = value;
  for (int i = window - 2; i >= 0; --i) {
    value = umbraCombine(umbraScaledTap(start + i * umbraAxis, layer, scale), value, layer);
    ends[i] = value;
  }

  float meanFactor = 1.0 / (float(window) * part);
  umbraStore(first, layer, ends[0], meanFactor);
  int count = min(window, length - begin);
  vec4 beginning = vec4(0.0);  // taps window … window+i-1 combined
  for (int i = 1; i < count; ++i) {
    vec4 tap = umbraScaledTap(start + (window + i - 1) * umbraAxis, layer, scale);
    beginning = i == 1 ? tap : umbraCombine(beginning, tap, layer);
    umbraStore(first + i * umbraAxis, layer, umbraCombine(ends[i], beginning, layer), meanFactor);
  }
}
