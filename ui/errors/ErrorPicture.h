// A frame's error as a picture in the colours of the error view.
#pragma once

#include <QImage>
#include <optional>

#include "analysis/errors/ErrorDecomposition.h"

namespace umbra {

// One part, or the whole error, in colours that are full at ±`range`; a little darker where the
// reference is in shadow, grey where no shadow falls, so that the scene is found in it.
// `reference` as ShadowRenderer gives it.
QImage errorPicture(const ErrorDecomposition& errors, std::optional<ErrorPart> part, double range,
                    const SurfaceImage& surfaces, const Image<float>& reference);

}  // namespace umbra
