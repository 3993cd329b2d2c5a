// What is said while lengths are measured, and the model is scaled.
#pragma once

#include "core/model/hint.h"
#include "core/model/step.h"

namespace fff::hints {

inline constexpr Text kMeasureFrom = FFF_TEXT(
    "Hint", "Drag from one place to another to measure; <kbd>Ctrl</kbd> turns snapping off. "
            "<kbd>Esc</kbd> ends.");
inline constexpr Text kSecondPlace =
    FFF_TEXT("Hint", "Move to the second place. <kbd>Esc</kbd> cancels.");
inline constexpr Text kMeasured =
    FFF_TEXT("Hint", "Click or drag to measure again. <kbd>Esc</kbd> clears it.");
inline constexpr Text kDimensionFrom = FFF_TEXT(
    "Hint",
    "Drag along something whose length you know; the whole model follows. <kbd>Esc</kbd> ends.");
inline constexpr Text kDimensionType = FFF_TEXT(
    "Hint",
    "Type the length you want; <kbd>Enter</kbd> scales the whole model. <kbd>Esc</kbd> cancels.");
inline constexpr Text kNotScaled =
    FFF_TEXT("Hint", "The model cannot be made that large or small.");
inline constexpr Text kNotScaledSoFar =
    FFF_TEXT("Hint", "The model cannot be scaled that far: %1 would go beyond its limits.");

} // namespace fff::hints

namespace fff {

/// Why the model cannot be made another size.
Hint notScaled(const Error &error);
Step scaledBy(double factor);

} // namespace fff
