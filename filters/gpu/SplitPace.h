// How the splits of layered techniques come to rest in front of the viewer.
#pragma once

namespace umbra {

// Two moved in a frame, in turn, from the last ones, so that no frame waits (Lauritzen 2008,
// §4.1.3); or all of them, from uniform ones, before the frame is drawn. The latter depends on the
// map alone and finds what `relax` finds on the CPU.
enum class SplitPace { Gradual, Converged };

}  // namespace umbra
