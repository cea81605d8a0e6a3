// The stages of a technique's channels that can be read back.
#pragma once

namespace umbra {

enum class BakeStage { Encoded, Prefiltered };

}  // namespace umbra
