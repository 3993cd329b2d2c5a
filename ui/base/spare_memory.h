// Memory that was freed and is still kept by the C library.
#pragma once

namespace fff::ui {

/// Back to the system, where its library keeps it and can be asked. Takes some ms: for when nothing
/// is going on.
void giveBackSpareMemory();

} // namespace fff::ui
