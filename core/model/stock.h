// A sheet material. Values of the built-in ones: fabrication data sheets, named beside each.
#pragma once

#include "core/base/ids.h"
#include "core/geometry/vector.h"
#include "core/model/spare_sheet.h"

#include <optional>
#include <string>
#include <vector>

namespace fff {

/// The inner end of a slit. A laser cuts it square; a mill's round tool reaches into no corner, so
/// that it takes more than the square end away, never less.
enum class SlitEnd {
    Square,
    Round,   // a round bottom beyond the square one
    Dogbone, // an arc through each corner, to both sides of it
    TBone    // an arc in each wall, at its corner; the bottom stays
};

/// What one machine removes of a stock.
struct MachineKerf
{
    std::string machine; // its key (core/fabrication/machine.h)
    double kerf = 0.0;   // mm, full width

    bool operator==(const MachineKerf &) const = default;
};

struct Stock
{
    StockId id;
    std::string name;
    double thickness = 3.0; // mm
    /// mm, by which it is sold, where that is not how thick it is: 4 for plywood of 3.8.
    std::optional<double> nominalThickness;
    bool isMeasured = false; // a person has said how thick the sheets are that will be cut
    double density = 1190.0; // kg/m³
    std::optional<double> tensileStrength;  // MPa; none: not rated
    std::optional<double> flexuralStrength; // MPa; none: not rated
    std::optional<double> modulus;          // MPa; none: not rated
    bool isDuctile = false;    // bends before it breaks, as metal does: strengths are yield
    double lastingShare = 1.0; // of its strengths that it bears for months, above 0; acrylic creeps
    double kerf = 0.15;        // mm, full width that the machine removes
    /// Of the machines that one is known of, ascending by key, each once: becomes `kerf` where it
    /// is cut for that machine (core/model/machine_kerfs.h).
    std::vector<MachineKerf> kerfs;
    double clearance = 0.0; // mm, play of a slit; negative presses
    SlitEnd slitEnd = SlitEnd::Square;
    double toolDiameter = 3.175;   // mm, of the mill; of no use to a square end
    double leadIn = 0.0;           // mm that a slit's mouth is chamfered by, at 45°
    double bumps = 0.0;            // mm, height of the two bumps in a slit that press on its guest
    Vec2 sheet = {600.0, 400.0};   // mm, width and height of one plate
    std::optional<int> sheetCount; // of those that there are; none: as many as it takes
    /// Offcuts and sheets of other sizes, used up before whole ones, in this order.
    std::vector<SpareSheet> spares;
    /// Of one plate, in the money that a person pays with, above 0; none: not known.
    std::optional<double> price;

    bool operator==(const Stock &) const = default;
};

/// What is more is nonsense.
inline constexpr int kMostSheets = 10000;

/// Whether the slits of sections of both stocks are the same.
bool cutsTheSameSlits(const Stock &a, const Stock &b);

/// Of its strengths that acrylic bears for months.
inline constexpr double kAcrylicForMonths = 0.25;

/// What a new document starts with: birch plywood, 3 mm.
/// How thick it is: what it was sold as it stays, unless it is another sheet that is so thick.
/// isMeasured: whatever comes of it
void setThickness(Stock &stock, double mm, bool isMeasured);

Stock birchPlywood();
/// What FlatFab's files mean: acrylic, an eighth of an inch, 60 MPa (paper, section Verification).
Stock flatfabAcrylic();

} // namespace fff
