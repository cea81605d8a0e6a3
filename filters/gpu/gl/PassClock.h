// How the passes of a frame are timed.
#pragma once

namespace umbra {

// Gpu: the GPU's timers. The frame never waits: only reading the times does. A software renderer
// charges a pass's rasterisation to whichever pass flushes next. Processor: the processor time of
// all threads. The frame waits for each pass, so that none pays for another.
enum class PassClock { Gpu, Processor };

}  // namespace umbra
