// What is typed into a field is not in the model until the field is left. Commands that read the
// model, or end its life, have it put there first.
#pragma once

namespace fff::ui {

/// Commits the field that has the focus, as leaving it does; it keeps the focus.
void commitOpenEditor();

} // namespace fff::ui
