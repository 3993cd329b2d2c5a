// What is selected in the view, said in words for whoever does not see it.
#pragma once

#include <QString>

namespace fff {
class CheckList;
}

namespace fff::ui {

class Workbench;

/// "Rib 3, section, birch plywood, on Body, no problem"; empty when nothing is selected.
QString spokenSelection(const Workbench &bench, const CheckList &checks);

} // namespace fff::ui
