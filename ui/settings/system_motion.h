// Whether the system is set to show little motion; Qt 6.4 cannot say.
#pragma once

namespace fff::ui {

/// Asked once. False where it cannot be known.
bool systemReducesMotion();

} // namespace fff::ui
