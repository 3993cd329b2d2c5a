#include "ui/docks/section_page.h"

#include "core/base/tolerances.h"
#include "core/interaction/sheet_editing.h"
#include "core/interaction/value_editing.h"
#include "core/model/edits.h"
#include "core/model/operation_edits.h"
#include "core/model/origin.h"
#include "core/model/sheet_edits.h"
#include "core/operations/drivable.h"
#include "ui/bench/measures.h"
#include "ui/bench/workbench.h"
#include "ui/docks/properties_header.h"
#include "ui/properties/driven_field.h"
#include "ui/properties/figure_group.h"
#include "ui/properties/instance_group.h"
#include "ui/properties/joint_rows.h"
#include "ui/properties/joint_words.h"
#include "ui/properties/magnet_group.h"
#include "ui/properties/mark_group.h"
#include "ui/properties/place_group.h"
#include "ui/properties/point_rows.h"
#include "ui/properties/property_rows.h"
#include "ui/properties/sheet_group.h"
#include "ui/properties/stock_choice.h"
#include "ui/properties/turning_choices.h"

#include <QEvent>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

namespace fff::ui {

namespace {

//: %1 is the name of a section
constexpr CountedText kSetStock{FFF_TEXT("Step", "Change stock of %1"),
                                FFF_TEXT_OF_MANY("Step", "Change stock of %n sections")};

constexpr LengthEdit::Range kThicknessRange{0.01, 1000.0, 0.05, 2, 3};
constexpr LengthEdit::Range kSizeRange{0.01, kMaxCoordinate, 0.5, 2, 2};
/// Sizes that differ by less, mm, are shown as one.
constexpr double kSameSize = 1e-7;

std::string nameOf(const Model &model, int index)
{
    return model.section(static_cast<std::size_t>(index))->name;
}

/// What all sections have in common, as text; null when they differ in it. The text is made only
/// where the value is another one than the section's before: thousands may be selected.
template <class Value, class Text>
QString commonText(const std::vector<int> &sections, Value valueOf, Text textOf)
{
    using Known = decltype(valueOf(0));
    std::optional<Known> last;
    QString common;
    for (const int i : sections) {
        const Known value = valueOf(i);
        if (last && *last == value)
            continue;
        const QString text = textOf(value);
        if (last && text != common)
            return {};
        last = value;
        common = text;
    }
    return common;
}

/// Of an image the drawn section; of another one that an operation made an exception of that.
Result<Document> setStockOf(const Model &model, Document document, const SectionRef &ref,
                            StockId stock)
{
    if (const std::optional<Origin> origin = originOf(model, ref))
        return setSectionStock(std::move(document), origin->section->id, stock);
    return document.find(ref.operation) ? setExceptionStock(std::move(document), ref, stock)
                                        : Result<Document>(std::move(document));
}

/// The stocks of these sections, each once.
std::set<StockId> stocksOf(const Model &model, const std::vector<int> &sections)
{
    std::set<StockId> stocks;
    for (int i : sections)
        stocks.insert(model.section(static_cast<std::size_t>(i))->stock);
    return stocks;
}

} // namespace

SectionPage::SectionPage(Workbench &bench, QWidget *parent) : QWidget(parent), m_bench(bench)
{
    m_pointGroup = new PointGroup(m_bench, this);
    m_instanceGroup = new InstanceGroup(m_bench, this);
    auto *stock = new PropertyGroup(tr("Stock"), this);
    m_sheetGroup = new SheetGroup(m_bench, this);
    m_placeGroup = new PlaceGroup(m_bench, this);
    m_figureGroup = new FigureGroup(m_bench, this);
    m_markGroup = new MarkGroup(m_bench, this);
    m_magnetGroup = new MagnetGroup(m_bench, this);
    m_jointGroup = new PropertyGroup(tr("Joints"), this);
    addStockRows(stock);
    addTurningRow(stock);
    addContourRows(m_figureGroup);
    m_joints = new JointRows(m_jointGroup);
    m_joints->setObjectName(QStringLiteral("jointList"));
    connect(m_joints, &JointRows::chosen, this, [this](const SectionRef &other) {
        const std::vector<SectionRef> &selected = m_bench.interaction().selection();
        if (selected.size() == 1)
            Q_EMIT jointWanted({selected.front(), other});
    });
    connect(m_joints, &JointRows::hovered, this, [this](const SectionRef &other) {
        m_bench.setOutlined(other == SectionRef() ? std::vector<SectionRef>()
                                                  : std::vector<SectionRef>{other});
    });
    m_jointGroup->add(m_joints);
    m_joints->installEventFilter(this);

    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_pointGroup);
    column->addWidget(m_instanceGroup);
    for (QWidget *group :
         {static_cast<QWidget *>(stock), static_cast<QWidget *>(m_sheetGroup),
          static_cast<QWidget *>(m_placeGroup), static_cast<QWidget *>(m_figureGroup),
          static_cast<QWidget *>(m_markGroup), static_cast<QWidget *>(m_magnetGroup),
          static_cast<QWidget *>(m_jointGroup)})
        column->addWidget(group);
}

void SectionPage::tellListed()
{
    m_bench.setListsJoints(m_joints->isVisible() && !m_joints->visibleRegion().isEmpty());
}

bool SectionPage::eventFilter(QObject *object, QEvent *event)
{
    const QEvent::Type type = event->type();
    if (object == m_joints && (type == QEvent::Show || type == QEvent::Hide ||
                               type == QEvent::Resize || type == QEvent::Paint))
        QMetaObject::invokeMethod(this, &SectionPage::tellListed, Qt::QueuedConnection);
    return QWidget::eventFilter(object, event);
}

void SectionPage::focusJoint(const SectionRef &other)
{
    m_joints->focusRow(other);
}

void SectionPage::addStockRows(PropertyGroup *group)
{
    auto *stock = new ChoiceRow(
        tr("Stock"), "sectionStock",
        [this] {
            const Model &model = m_bench.session().model();
            const std::set<StockId> used = stocksOf(model, m_selected);
            return choicesOfStock(model.document,
                                  used.size() == 1 ? std::optional(*used.begin()) : std::nullopt);
        },
        [this](int index) {
            const Model &model = m_bench.session().committed();
            const Stock choice = stockChoices(model.document).at(static_cast<std::size_t>(index));
            StockId id;
            Result<Document> next = withStock(model.document, choice, id);
            std::vector<std::string> names;
            for (int i : selectedSections(m_bench)) {
                names.push_back(nameOf(model, i));
                if (next)
                    next = setStockOf(model, *std::move(next),
                                      model.ref(static_cast<std::size_t>(i)), id);
            }
            m_bench.commit(ofSections(kSetStock, names), std::move(next));
        },
        group);
    stock->addButton(QStringLiteral("stocks"), "sectionStockEdit", tr("Edit the stock"), [this] {
        const std::set<StockId> used =
            stocksOf(m_bench.session().model(), selectedSections(m_bench));
        if (!used.empty())
            Q_EMIT stockWanted(*used.begin());
    });
    auto *thickness = new LengthRow(
        tr("Thickness"), "sectionThickness", kThicknessRange, [this] { return commonThickness(); },
        [this](double value) {
            const std::set<StockId> used =
                stocksOf(m_bench.session().committed(), selectedSections(m_bench));
            commitThickness(m_bench, std::vector(used.begin(), used.end()), value);
        },
        group);
    thickness->setThickness([this] { return commonThickness(); });
    thickness->setFollowed(followedAt(m_bench, [this]() -> std::optional<DrivenPlace> {
        const std::set<StockId> used = stocksOf(m_bench.session().model(), m_selected);
        if (used.size() != 1)
            return std::nullopt;
        return DrivenPlace{
            .of = DrivenPlace::Of::Stock, .id = used.begin()->value, .field = "thickness"};
    }));
    thickness->setToolTip(tr("Thickness of the stock: all sections of this stock follow"));
    auto *mass = new TextRow(
        tr("Mass"), "sectionMass",
        [this] {
            const Measures measures(m_bench.session());
            double sum = 0.0;
            for (int i : m_selected)
                sum += measures.mass(i);
            return massText(sum, locale());
        },
        group);
    for (PropertyRow *row :
         {static_cast<PropertyRow *>(stock), static_cast<PropertyRow *>(thickness),
          static_cast<PropertyRow *>(mass)}) {
        group->add(row);
        m_rows.push_back(row);
    }
}

/// The first choice is that of all sections, on the page of the sheets.
void SectionPage::addTurningRow(PropertyGroup *group)
{
    const auto read = [this] {
        const Model &model = m_bench.session().model();
        std::set<std::optional<nest::Turning>> wanted;
        for (const int i : m_selected)
            wanted.insert(turningOf(model.document, *model.section(static_cast<std::size_t>(i))));
        Choices choices = turningChoices(nest::Turning::Free);
        choices.all.insert(choices.all.begin(), {tr("As all others"), {}});
        choices.current = -1;
        if (wanted.size() == 1)
            choices.current = *wanted.begin() ? 1 + turningChoices(**wanted.begin()).current : 0;
        return choices;
    };
    const auto write = [this](int choice) {
        const Model &model = m_bench.session().committed();
        const auto wanted = choice > 0 ? std::optional(turningOf(choice - 1)) : std::nullopt;
        m_bench.editSections(turnedOnSheets(model, model.refs(selectedSections(m_bench)), wanted));
    };
    auto *row = new ChoiceRow(tr("Rotation"), "sectionTurning", read, write, group);
    row->setToolTip(tr("How its parts may be turned on the sheet: one that keeps to the grain lies "
                       "as it is drawn, or by half turns"));
    group->add(row);
    m_rows.push_back(row);
}

/// Of one drawn section a field, of others only what they have in common.
void SectionPage::addSize(PropertyGroup *group, const QString &name, const char *objectName,
                          const char *field, int axis)
{
    const PlaceNow place = selectedSectionPlace(m_bench, DrivenPlace::Of::Section, field);
    const auto read = [this, place, axis]() -> std::optional<double> {
        if (const std::optional<DrivenPlace> at = place())
            if (const auto known = drivenNumber(m_bench.session().model().document, *at))
                return known->worth.number;
        const Measures measures(m_bench.session());
        std::optional<double> common;
        for (const int i : m_selected) {
            const double size = measures.contourSize(i)[axis];
            if (common && std::abs(*common - size) > kSameSize)
                return std::nullopt;
            common = common ? common : size;
        }
        return common;
    };
    const auto write = [this, place](double size) {
        const std::optional<DrivenPlace> at = place();
        if (!at)
            return;
        const Reading millimetres;
        const std::string typed =
            QString::number(size, 'g', QLocale::FloatingPointShortest).toStdString() + " mm";
        m_bench.editSections(
            numberBound(m_bench.session().committed().document, *at, typed, millimetres));
        refresh(); // shows what it is where that was refused
    };
    auto *row = new LengthRow(name, objectName, kSizeRange, read, write, group);
    row->setFollowed(followedAt(m_bench, place));
    row->setToolTip(tr("Another length stretches the contour about its slit, or its middle"));
    group->add(row);
    m_rows.push_back(row);
    m_sizes.push_back({row, place});
}

void SectionPage::addContourRows(PropertyGroup *group)
{
    const auto add = [this, group](const QString &name, const char *objectName,
                                   std::function<QString()> read) {
        auto *row = new TextRow(name, objectName, std::move(read), group);
        group->add(row);
        m_rows.push_back(row);
    };
    const auto shapeOf = [this](int i) -> const Shape & {
        return *m_bench.session().model().section(static_cast<std::size_t>(i))->shape;
    };
    addSize(group, tr("Width"), "sectionWidth", "width", 0);
    addSize(group, tr("Height"), "sectionHeight", "height", 1);
    add(tr("Area"), "sectionArea", [this] {
        const Measures measures(m_bench.session());
        double sum = 0.0;
        for (int i : m_selected)
            sum += measures.area(i);
        return areaText(sum, locale());
    });
    add(tr("Points"), "sectionPoints", [this, shapeOf] {
        // A closed chain of n curves has 3 n control points, n of them on the contour.
        return commonText(
            m_selected, [&](int i) { return shapeOf(i).controlPointCount() / 3; },
            [this](auto count) { return locale().toString(count); });
    });
    add(tr("Holes"), "sectionHoles", [this, shapeOf] {
        return commonText(
            m_selected, [&](int i) { return static_cast<qulonglong>(shapeOf(i).holes().size()); },
            [this](qulonglong count) {
                return count == 0 ? tr("none") : locale().toString(count);
            });
    });
}

/// That all selected sections share.
std::optional<double> SectionPage::commonThickness() const
{
    const Model &model = m_bench.session().model();
    std::set<double> values;
    for (StockId id : stocksOf(model, m_selected))
        values.insert(model.document.find(id)->thickness);
    return values.size() == 1 ? std::optional(*values.begin()) : std::nullopt;
}

void SectionPage::refresh()
{
    m_selected = selectedSections(m_bench);
    for (PropertyRow *row : m_rows)
        row->refresh();
    for (const Size &size : m_sizes)
        size.row->setEnabled(size.place().has_value());
    m_pointGroup->refresh();
    m_instanceGroup->refresh();
    m_sheetGroup->refresh();
    m_placeGroup->refresh();
    m_figureGroup->refresh();
    m_markGroup->refresh();
    m_magnetGroup->refresh();
    refreshJoints();
}

/// Of one section; of several there is no list that says anything.
void SectionPage::refreshJoints()
{
    const Model &model = m_bench.session().model();
    m_jointGroup->setVisible(m_selected.size() == 1);
    if (m_selected.size() != 1)
        return;
    const Analysis &analysis = m_bench.session().analysis();
    const int here =
        analysis.model.indexOf(model.ref(static_cast<std::size_t>(m_selected.front())));
    std::vector<JointRows::Entry> entries;
    for (const Joint &joint : analysis.assembly.joints) {
        if (here < 0 || (joint.a != here && joint.b != here))
            continue;
        const auto other = static_cast<std::size_t>(joint.a == here ? joint.b : joint.a);
        double length = 0.0;
        for (const Overlap &overlap : joint.crossing->overlaps)
            length += overlap.to - overlap.from;
        const QString size = lengthText(length, 1, 1, locale());
        entries.push_back({analysis.model.ref(other),
                           QString::fromStdString(analysis.model.section(other)->name),
                           tr("%1 · %2").arg(jointKindText(joint.kind), size),
                           joint.kind == JointKind::None, size});
    }
    m_joints->setEntries(entries);
}

} // namespace fff::ui
