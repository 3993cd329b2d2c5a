// A whole model made larger or smaller.
#pragma once

#include "core/model/document.h"

namespace fff {

/// All lengths of what is drawn times `factor`, about the world's origin: places and contours of
/// sections, what is drawn on them, places of weights, dimensions, and the operations' lengths.
/// Stocks and masses stay. What shares a shape shares the new one. Scaling by the inverse gives
/// the same back but for rounding.
///
/// factor  above 0
/// Errors  BadValue, place "factor"; BadValue, place = the operation's name, args = the value and
///         its range, where a length of one would be out of it; EmptyContour and NonFinite, place =
///         the section's name, where next to nothing is left of it or it leaves all bounds.
Result<Document> scaledModel(Document document, double factor);

} // namespace fff
