// How much is drawn of a frame.
#pragma once

namespace fff::ui {

/// Full    smooth edges, darkened corners, every layer of what lets light through: the picture at
///         rest and that of files
/// Plain   one sample a pixel, no darkened corners, the nearest layers only
/// Coarse  as Plain, at half the resolution; what lets light through is of its colour over the
///         background, and hides what is behind it
enum class FrameQuality { Full, Plain, Coarse };

} // namespace fff::ui
