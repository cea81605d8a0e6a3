// How the splits of layered techniques come to rest in front of the viewer.
#pragma once

namespace umbra {

// Gradual moves two splits in a frame, in turn, starting from the last splits, so that no frame
// waits (Lauritzen 2008, §4.1.3). Converged moves all of them, starting from uniform splits, before
// the frame is drawn; its result depends on the map alone and agrees with that of `relax` on the
// CPU.
enum class SplitPace { Gradual, Converged };

}  // namespace umbra
