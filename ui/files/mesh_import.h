// Meshes that come into the model as templates: asked for, read beside the window, and put there as
// one step.
#pragma once

#include "core/base/ids.h"

#include <QString>

#include <functional>

class QWidget;

namespace fff::ui {

class Workbench;
struct ClipboardPicture;

/// "Meshes (*.stl *.obj …);;All files (*)"
QString meshFilter();
bool isMeshFile(const QString &path);

/// What there is to be said when it is over: what was wrong with the file; empty: nothing.
struct MeshImported
{
    bool isAdded = false;
    QString error = {};   // it was not read
    QString remarks = {}; // what was mended in it
    QString sized = {};   // what size it was given, where its file knows no unit
    /// Where another such mesh is there, at another scale: what it would be to have the same, for
    /// those that belong together.
    QString likeOther = {};
    std::function<void()> takeScale = {};
};
/// Does nothing where it is given up.
MeshImported importMesh(QWidget &window, Workbench &bench, const QString &path);
/// The same of what was copied.
MeshImported importPicture(QWidget &window, Workbench &bench, const ClipboardPicture &picture);

/// What a template holds is read from another file, or from where its file is now, and lies where
/// it lay. isByReference: the model's file has its bytes no more.
MeshImported refillTemplate(QWidget &window, Workbench &bench, TemplateId id, const QString &path,
                            bool isByReference);

} // namespace fff::ui
