#include "ui/docks/section_page.h"

#include "core/base/tolerances.h"
#include "core/base/units.h"
#include "core/model/edits.h"
#include "core/model/operation_edits.h"
#include "core/model/origin.h"
#include "ui/docks/properties_header.h"
#include "ui/measures.h"
#include "ui/properties/instance_group.h"
#include "ui/properties/joint_rows.h"
#include "ui/properties/joint_words.h"
#include "ui/properties/point_rows.h"
#include "ui/properties/property_rows.h"
#include "ui/properties/stock_choice.h"
#include "ui/workbench.h"

#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

namespace fff::ui {

namespace {

constexpr LengthEdit::Range kThicknessRange{0.01, 1000.0, 0.05, 2, 3};
constexpr LengthEdit::Range kPositionRange{-kMaxCoordinate, kMaxCoordinate, 0.1, 2, 2};

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

std::optional<double> commonNumber(const std::vector<int> &sections,
                                   const std::function<double(int)> &numberOf)
{
    std::optional<double> common;
    for (const int i : sections) {
        const double number = numberOf(i);
        if (common && *common != number)
            return {};
        common = number;
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
    auto *place = new PropertyGroup(tr("Place"), this);
    m_placeGroup = place;
    auto *contour = new PropertyGroup(tr("Contour"), this);
    m_jointGroup = new PropertyGroup(tr("Joints"), this);
    addStockRows(stock);
    addPlaceRows(place);
    addContourRows(contour);
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

    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_pointGroup);
    column->addWidget(m_instanceGroup);
    for (QWidget *group : {stock, place, contour, m_jointGroup})
        column->addWidget(group);
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
            m_bench.commit({Step::Kind::SetStock, names}, std::move(next));
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
    thickness->setToolTip(tr("That of the stock: all sections of it follow"));
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

void SectionPage::addPlaceRows(PropertyGroup *group)
{
    const auto add = [this, group](PropertyRow *row) {
        group->add(row);
        m_rows.push_back(row);
    };
    const auto parentOf = [this](int i) {
        const Model &model = m_bench.session().model();
        const auto &link = model.section(static_cast<std::size_t>(i))->parent;
        return link ? model.indexOf(link->section) : -1;
    };
    const auto normalOf = [this](int i) -> Vec3 {
        return m_bench.session().model().section(static_cast<std::size_t>(i))->frame.normal();
    };
    /// Of the angle to the parent; above 1 without one.
    const auto cosineOf = [parentOf, normalOf](int i) {
        constexpr double kNone = 2.0;
        const int on = parentOf(i);
        return on < 0 ? kNone : std::clamp(std::abs(normalOf(i).dot(normalOf(on))), 0.0, 1.0);
    };
    add(new TextRow(
        tr("On"), "sectionParent",
        [this, parentOf] {
            return commonText(m_selected, parentOf, [this](int on) {
                return on < 0 ? tr("nothing")
                              : QString::fromStdString(nameOf(m_bench.session().model(), on));
            });
        },
        group));
    add(new TextRow(
        tr("Angle to it"), "sectionAngle",
        [this, cosineOf] {
            return commonText(m_selected, cosineOf, [this](double cosine) {
                return cosine > 1.0
                           ? QStringLiteral("\u2013")
                           : tr("%1°").arg(numberText(degrees(std::acos(cosine)), 0, 1, locale()));
            });
        },
        group));
    add(positionRow(0, tr("Position X"), "positionX", group));
    add(positionRow(1, tr("Position Y"), "positionY", group));
    add(positionRow(2, tr("Position Z"), "positionZ", group));
    add(new TextRow(
        tr("Normal"), "sectionNormal",
        [this, normalOf] {
            return commonText(m_selected, normalOf, [this](const Vec3 &normal) {
                QStringList numbers;
                for (int axis : {0, 1, 2}) // no minus before a zero
                    numbers += numberText(std::round(normal[axis] * 1000.0) / 1000.0 + 0.0, 0, 3,
                                          locale());
                return numbers.join(QStringLiteral("  "));
            });
        },
        group));
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
    add(tr("Size"), "sectionSize", [this] {
        const Measures measures(m_bench.session());
        return commonText(
            m_selected, [&](int i) -> Vec2 { return measures.contourSize(i); },
            [this](const Vec2 &size) {
                return sizeText({size.x(), size.y()}, 1, locale());
            });
    });
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

/// Of the frame's origin; a new value moves the section along the world's axis.
PropertyRow *SectionPage::positionRow(int axis, const QString &name, const char *objectName,
                                      QWidget *parent)
{
    auto *row = new LengthRow(
        name, objectName, kPositionRange,
        [this, axis]() -> std::optional<double> {
            const Model &model = m_bench.session().model();
            return commonNumber(m_selected, [&](int i) {
                return model.section(static_cast<std::size_t>(i))->frame.origin[axis];
            });
        },
        [this, axis](double value) {
            const Model &model = m_bench.session().committed();
            Result<Document> next = model.document;
            std::vector<std::string> names;
            std::set<SectionId> moved; // a section and its image may both be selected
            for (int i : selectedSections(m_bench)) {
                const auto origin = originOf(model, model.ref(static_cast<std::size_t>(i)));
                if (!origin || !moved.insert(origin->section->id).second)
                    continue; // its place is its operation's
                Vec3 by = Vec3::Zero();
                by[axis] = value - model.section(static_cast<std::size_t>(i))->frame.origin[axis];
                Frame frame = origin->section->frame;
                frame.origin += origin->turn.transpose() * by;
                names.push_back(nameOf(model, i));
                if (next)
                    next = moveSection(*std::move(next), origin->section->id, frame);
            }
            m_bench.commit({Step::Kind::MoveSection, names}, std::move(next));
        },
        parent);
    row->setThickness([this] { return commonThickness(); });
    return row;
}

void SectionPage::refresh()
{
    m_selected = selectedSections(m_bench);
    for (PropertyRow *row : m_rows)
        row->refresh();
    m_pointGroup->refresh();
    m_instanceGroup->refresh();
    // Where an operation puts a section is said there.
    const Model &model = m_bench.session().model();
    m_placeGroup->setVisible(std::all_of(m_selected.begin(), m_selected.end(), [&](int i) {
        return originOf(model, model.ref(static_cast<std::size_t>(i))).has_value();
    }));
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
        entries.push_back(
            {analysis.model.ref(other), QString::fromStdString(analysis.model.section(other)->name),
             tr("%1 · %2").arg(jointKindText(joint.kind), lengthText(length, 1, 1, locale())),
             joint.kind == JointKind::None});
    }
    m_joints->setEntries(entries);
}

} // namespace fff::ui
