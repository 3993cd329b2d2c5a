// What is selected in the view, said in words for whoever does not see it.
#pragma once

#include <QString>

class QWidget;

namespace fff {
class CheckList;
}

namespace fff::ui {

class Workbench;

/// Keeps the view's description at what is selected; with nothing selected it says what it did
/// before.
void speakSelection(QWidget &view, const Workbench &bench, const CheckList &checks);

/// "Rib 3, section, birch plywood, on Body, no problem"; empty when nothing is selected.
QString spokenSelection(const Workbench &bench, const CheckList &checks);

} // namespace fff::ui
