// What a person has chosen for cutting files apart from what is the document's, kept from one
// export to the next: it is of the machine and the habits, not of the model.
#pragma once

#include "core/analysis/cutting.h"
#include "core/fabrication/cut_finish.h"
#include "core/fabrication/machine.h"
#include "core/io/formats.h"

#include <QString>
#include <QStringList>

#include <memory>
#include <optional>
#include <vector>

namespace fff::ui {

/// One of the files that Export can write.
struct ExportFile
{
    QString key;  // by which it is remembered
    QString text; // "SVG, true to size"
    io::FileUse use = io::FileUse::Cutting;
    bool isSolids = false; // has no sheets, nor a kerf
    bool isFilePerSheet = false;
    bool isSkin = false;     // of those without sheets, the one that has no parts either
    bool isFolder = false;   // of several files
    bool isColoured = false; // its colours are looked at, or may be
};

struct ExportChoices
{
    LayoutOptions
        layout; // without a sheet: that is the stock's; nestOut() does not ask if it turns
    nest::Turning turning = nest::Turning::Free;
    bool fillsHoles = true; // parts lie in holes of others
    bool hasReference = true;
    bool hasJointColours = false;    // where the file's colours are looked at
    std::optional<CutFinish> finish; // none: as the machine has it
    QString machine; // key in the library (core/io/machine_library.h); empty: none in particular
    bool opensFolder = false; // afterwards
    QString file;             // key; empty: the first there is
    QStringList files;        // the same of each use, the newest first

    /// By its key; null: none in particular.
    std::shared_ptr<const Machine> chosenMachine() const;
    /// How cuts will be made.
    CutFinish cuts() const;
    CuttingOptions cutting() const;
    NestOptions nesting() const;
};

// mm
inline constexpr double kMostSpacing = 50.0, kMostMargin = 100.0;

ExportChoices rememberedChoices();
void rememberChoices(const ExportChoices &choices);

} // namespace fff::ui
