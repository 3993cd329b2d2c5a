// What the system's settings ask of programs for those who need it.
#pragma once

namespace fff::ui {

/// Little or no motion; asked once.
bool systemReducesMotion();
/// High contrast, as it is set now.
bool systemWantsContrast();

} // namespace fff::ui
