// What file dialogs offer, from the table of formats (core/io/formats.h).
#pragma once

#include "core/io/formats.h"

#include <QString>

#include <vector>

namespace fff::ui {

/// "Models (*.fff *.txt);;All files (*)"
QString modelFilter();
QString drawingFilter();
/// "FlatFitFab models (*.fff)"
QString saveFilter();

/// One row of what Export offers.
struct ExportKind
{
    QString key;    // by which it is remembered: "svg", "svg/sheets", "pdf/a4"
    QString title;  // "Drawings for cutters"
    QString filter; // "Drawings for cutters (*.svg)"
    const io::Format *format = nullptr;
    bool isFilePerSheet = false;
    bool isSkin = false;   // of the model, in place of its solids
    bool isFolder = false; // of several files
    io::FileUse use = io::FileUse::Cutting;
    io::FormatValues values; // of the format's options
};
/// Never empty; cutting files first.
std::vector<ExportKind> exportKinds();
/// The first where there is none of this key (any more).
ExportKind exportKindNamed(const QString &key);

} // namespace fff::ui
