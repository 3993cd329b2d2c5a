// Files that are dropped on a window or named as the program starts, by what becomes of them.
#pragma once

#include <QStringList>

namespace fff::ui {

struct GivenFiles
{
    QStringList models;   // each in a window
    QStringList drawings; // of other programs (.svg and the like): sections
    QStringList meshes;   // and pictures: templates
};

/// By their endings. What none of them has is a model, and its reader says what is wrong.
GivenFiles givenFiles(const QStringList &paths);

} // namespace fff::ui
