#include "ui/properties/sheet_group.h"

#include "core/analysis/lying_parts.h"
#include "core/analysis/nested.h"
#include "core/base/units.h"
#include "core/geometry/turning.h"
#include "core/interaction/sheet_editing.h"
#include "core/model/sheet_edits.h"
#include "core/session/sheet_nesting.h"
#include "ui/base/lengths.h"
#include "ui/bench/workbench.h"

#include <QCheckBox>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace fff::ui {

namespace {

constexpr double kWholeTurn = 360.0; // degrees

/// A part that lies on a sheet.
struct LyingPart
{
    PinnedPlace place;
    int number = 0;      // of its sheet, from 1 on
    int sheets = 0;      // of its stock
    bool fits = true;    // else its sheet is only as large as it is
    Vec2 corner{0, 0};   // lower left of its box, mm
    bool isOnly = false; // its section has no other part
};

/// Of that section, the first of its parts; nothing where that is not known.
std::optional<LyingPart> lyingPartOf(const Nested &nested, const SectionRef &section)
{
    if (!nested.parts || !nested.layout)
        return std::nullopt;
    const std::vector<Part> &parts = nested.parts->parts;
    const BodiesOfParts bodies = bodiesOfParts(nested.analysis->model, parts);
    const auto found = bodies.partOf.find({section, 0});
    if (found == bodies.partOf.end())
        return std::nullopt;
    LyingPart lying;
    lying.isOnly = !bodies.partOf.contains({section, 1});
    const std::vector<int> &oversized = nested.layout->oversized;
    lying.fits = std::find(oversized.begin(), oversized.end(), found->second) == oversized.end();
    const StockId stock = parts[static_cast<std::size_t>(found->second)].stock;
    bool isFound = false;
    const auto isOversized = [&](const Sheet &sheet) {
        return !sheet.placements.empty() &&
               std::find(oversized.begin(), oversized.end(), sheet.placements.front().part) !=
                   oversized.end();
    };
    for (const Sheet &sheet : nested.layout->sheets) {
        if (sheet.stock != stock)
            continue;
        lying.sheets += isOversized(sheet) ? 0 : 1; // in the order in which they are shown
        for (const Placement &placement : sheet.placements) {
            if (placement.part != found->second)
                continue;
            isFound = true;
            lying.number = lying.sheets;
            lying.place = {section, 0, sheet.index, placement.turn, placement.offset};
            const Part &part = parts[static_cast<std::size_t>(placement.part)];
            lying.corner =
                turnedBounds(part.outline.region.outer, placement.turn).min + placement.offset;
        }
    }
    return isFound ? std::optional(lying) : std::nullopt;
}

/// Of the one section that is selected.
std::optional<LyingPart> chosenPart(Workbench &bench)
{
    const std::vector<SectionRef> &selected = bench.interaction().selection();
    const SheetNesting &nesting = bench.nesting();
    const std::shared_ptr<const Nested> &nested = nesting.result();
    if (selected.size() != 1 || !nesting.isWanted() || !nested)
        return std::nullopt;
    return lyingPartOf(*nested, selected.front());
}

} // namespace

SheetGroup::SheetGroup(Workbench &bench, QWidget *parent)
    : PropertyGroup(tr("On the sheet"), parent), m_bench(bench)
{
    addText(tr("Sheet"), "sectionSheet", m_sheet);
    addText(tr("Position X, Y"), "sectionSheetPlace", m_position);
    addText(tr("Turned by"), "sectionSheetTurn", m_turn);
    m_pinned = new QCheckBox(tr("keeps its place"), this);
    auto *row = new EditorRow(
        tr("Pinned"), "sectionPinned", m_pinned,
        [this] {
            const Document &document = m_bench.session().committed().document;
            m_pinned->setChecked(m_place && pinOf(document, m_place->section, m_place->body));
            m_pinned->setEnabled(m_fits);
        },
        this);
    row->setToolTip(tr("P pins and unpins the selected part among the sheets"));
    add(row);
    m_rows.push_back(row);
    connect(m_pinned, &QCheckBox::clicked, this, &SheetGroup::pin);
    connect(&bench.nesting(), &SheetNesting::changed, this, &SheetGroup::refresh);
    refresh();
}

/// text  read whenever the row is
void SheetGroup::addText(const QString &name, const char *objectName, const QString &text)
{
    auto *row = new TextRow(
        name, objectName, [&text] { return text; }, this);
    add(row);
    m_rows.push_back(row);
}

void SheetGroup::pin(bool isOn)
{
    if (!m_place)
        return;
    const Model &model = m_bench.session().committed();
    m_bench.editSections(isOn ? pinnedOnSheets(model, {*m_place})
                              : unpinned(model, std::vector{m_place->section}));
}

void SheetGroup::refresh()
{
    const std::optional<LyingPart> part = chosenPart(m_bench);
    setVisible(part.has_value());
    m_place.reset();
    if (!part)
        return;
    m_place = part->place;
    m_fits = part->fits;
    const QString which = tr("%1 of %2").arg(part->number).arg(part->sheets);
    m_sheet = !part->fits    ? tr("too large for one")
              : part->isOnly ? which
                             //: %1 is "1 of 2"
                             : tr("%1, its first part").arg(which);
    m_position = QStringLiteral("%1 × %2").arg(lengthNumber(part->corner.x(), 1, 1, locale()),
                                               lengthText(part->corner.y(), 1, 1, locale()));
    const double angle = degrees(std::atan2(part->place.turn.y(), part->place.turn.x()));
    m_turn = locale().toString(angle < 0.0 ? angle + kWholeTurn : angle, 'f', 1) + u'°';
    for (PropertyRow *row : m_rows)
        row->refresh();
}

} // namespace fff::ui
