// What the Sheets dock shows: the sheets as they will be cut, and whose parts lie there.
#pragma once

#include "core/model/section.h"
#include "ui/dialogs/cutting_work.h"

#include <QString>

#include <memory>
#include <vector>

namespace fff::ui {

/// A part that is shown: indices.
struct SheetSpot
{
    std::size_t sheet = 0, part = 0;
    bool operator==(const SheetSpot &) const = default;
};

struct PartOnSheet
{
    SectionRef section;
    int body = 0;                                // of the section
    Vec2 size = Vec2::Zero();                    // of its box as drawn, mm
    double turn = 0.0;                           // degrees, counter-clockwise, 0 … 360
    nest::Turning turning = nest::Turning::Free; // how it may be turned
    bool keepsToGrain = false;                   // by a wish of its own
    bool isPinned = false;
};

struct SheetFacts
{
    std::vector<PartOnSheet> parts; // as the sheet's paths have them
    bool isTooLarge = false;        // the sheet is its part's size: it fits none
    bool isOffcut = false;          // or of another size than whole ones
    double usedShare = 0.0;         // of what is taken of it, 0 … 1
    QString stock;                  // its name; empty where all are of one
};

struct SheetsContent
{
    std::shared_ptr<const CuttingWork::Made> made; // null: nothing is to be seen
    std::vector<SheetFacts> facts;                 // of each sheet
    double margin = 0.0;                           // mm
    bool hasGrain = false;                         // parts keep to it
    bool isOlder = false;                          // than the model
    QString note;                                  // in their place, where there are none

    const std::vector<SheetPaths> &sheets() const;
};

/// made  may be null
SheetsContent sheetsContent(std::shared_ptr<const CuttingWork::Made> made);

} // namespace fff::ui
