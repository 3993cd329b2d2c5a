#include "core/model/materials.h"

#include <array>

namespace fff {

namespace {

/// Strengths and modulus in MPa; 0: not rated, no value that can be stood by is published.
struct Row
{
    const char *name;
    double thickness, density; // mm, kg/m³
    double tensile, flexural, modulus;
    double kerf, clearance; // mm
    Vec2 sheet;             // mm
    std::vector<double> thicknesses;
    bool isDuctile = false;
    double lastingShare = 1.0; // see Stock
};

// Where a material is weaker one way, the weaker way stands here. Kerfs are those of a CO2 laser
// (laserengravingservice.co.uk, artwork preparation guide); clearances what a press fit wants.
std::vector<Row> rows()
{
    return {
        // Plywood: density and real thickness by Lathams' birch plywood data sheet (sold as 4 mm:
        // 3.8, 3.5 to 4.1; as 6.5 mm: 6.4, 6.1 to 6.9). Strength across the grain by
        // otpplywood.com,
        // film-faced birch: bending 30, tensile 25, modulus 4.0 GPa.
        {"Birch plywood 4 mm", 3.8, 660, 25, 30, 4000, 0.20, 0.0, {600, 400}, {3.8}},
        {"Birch plywood 6.5 mm", 6.4, 670, 25, 30, 4000, 0.25, 0.0, {600, 400}, {6.4}},
        {"Birch plywood 9 mm", 9.0, 710, 25, 30, 4000, 0.25, 0.0, {600, 400}, {9.0}},
        // MDF: bending 25 at least and modulus 2.5 GPa at least by mangalamtimber.com, interior
        // grade (IS 12406); density of thin board 860 to 880, Dongwha's specification. No tensile
        // strength in the plane is given there.
        {"MDF", 3.0, 860, 0, 25, 2500, 0.18, 0.0, {600, 400}, {3.0, 6.0}},
        // PMMA: tensile 69, flexural 117, modulus 2.8 (tensile) by usplastic.com, knowledge base
        // 533; density the same. For months a quarter of that, as it creeps and crazes: the
        // product's mechanics, 2.10.
        {"Acrylic, clear",
         3.0,
         1190,
         69,
         117,
         2800,
         0.15,
         0.05,
         {600, 400},
         {3.0, 6.0, 10.0},
         false,
         kAcrylicForMonths},
        {"Acrylic, red",
         3.0,
         1190,
         69,
         117,
         2800,
         0.15,
         0.05,
         {600, 400},
         {3.0, 6.0, 10.0},
         false,
         kAcrylicForMonths},
        // Corrugated board: thickness of the flutes by packaging.vip; density of single wall C from
        // its papers (2 · 125 + 1.43 · 125 g/m² over 4 mm), the same papers over 3 and 1.5 mm for B
        // and E (take-up factors 1.32 and 1.27). Strength hangs on the direction: not rated.
        {"Corrugated board B", 3.0, 138, 0, 0, 0, 0.15, -0.2, {508, 305}, {3.0}},
        {"Corrugated board C", 4.0, 107, 0, 0, 0, 0.15, -0.2, {508, 305}, {4.0}},
        {"Corrugated board E", 1.5, 273, 0, 0, 0, 0.15, -0.1, {508, 305}, {1.5, 1.0}},
        // Card: kerf as above; 0.3 mm of 240 g/m² is 800 kg/m³. No strength is published for it.
        {"Card", 0.3, 800, 0, 0, 0, 0.08, 0.0, {297, 210}, {0.3, 0.5, 1.0}},
        // Basswood: density, bending and modulus by advantagelumber.com; tensile across the grain
        // 350 psi by clchardwoods.com. It splits along the grain, so 2.4 is what both rows get.
        {"Basswood", 3.0, 415, 2.4, 2.4, 10100, 0.20, 0.0, {300, 200}, {1.5, 3.0, 5.0}},
        // POM-C: Engineering Plastics Handbook, table 5.5: tensile 65, flexural 89, modulus 2.5.
        {"POM", 3.0, 1410, 65, 89, 2500, 0.20, 0.05, {600, 400}, {3.0, 5.0}},
        // 6061-T6: 310 MPa ultimate, 69 GPa, 2700 kg/m³ by FreeCAD's material card. Milled, not
        // lasered: no kerf, since tool paths are offset by the machine's program. A ductile metal
        // bends where it breaks, so flexural strength is not rated apart.
        {"Aluminium 6061", 3.0, 2700, 310, 0, 69000, 0.0, 0.1, {300, 200}, {2.0, 3.0, 5.0}, true},
    };
}

std::vector<Material> made()
{
    std::vector<Material> all;
    const auto rated = [](double v) { return v > 0.0 ? std::optional(v) : std::nullopt; };
    for (Row &row : rows()) {
        Material material;
        Stock &stock = material.stock;
        stock.name = row.name;
        stock.thickness = row.thickness;
        stock.density = row.density;
        stock.tensileStrength = rated(row.tensile);
        stock.flexuralStrength = rated(row.flexural);
        stock.modulus = rated(row.modulus);
        stock.kerf = row.kerf;
        stock.clearance = row.clearance;
        stock.sheet = row.sheet;
        stock.isDuctile = row.isDuctile;
        stock.lastingShare = row.lastingShare;
        material.thicknesses = std::move(row.thicknesses);
        all.push_back(std::move(material));
    }
    return all;
}

} // namespace

std::span<const Material> materials()
{
    static const std::vector<Material> all = made();
    return all;
}

std::span<const SheetSize> commonSheets()
{
    // Beds by the device profiles of rayforge and MeerK40t; Glowforge's stock 12 × 20 in; largest
    // sheets of Snijlab and Laser Garage.
    static const std::array<SheetSize, 12> all{{{"A4", {297, 210}},
                                                {"A3", {420, 297}},
                                                {"Letter", {279.4, 215.9}},
                                                {"K40 laser", {300, 200}},
                                                {"12 × 20 in", {508, 304.8}},
                                                {"", {400, 400}},
                                                {"", {600, 300}},
                                                {"", {600, 400}},
                                                {"", {700, 500}},
                                                {"", {900, 600}},
                                                {"", {1200, 600}},
                                                {"Whole plywood board", {1525, 1525}}}};
    return all;
}

} // namespace fff
