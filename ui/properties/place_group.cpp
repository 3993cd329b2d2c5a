#include "ui/properties/place_group.h"

#include "core/base/tolerances.h"
#include "core/base/units.h"
#include "core/interaction/contour_target.h"
#include "core/interaction/section_editing.h"
#include "core/model/bindings.h"
#include "core/model/holds_to_names.h"
#include "core/model/moving.h"
#include "core/model/origin.h"
#include "core/model/symmetric_section.h"
#include "core/model/value_names.h"
#include "core/session/message_text.h"
#include "ui/bench/workbench.h"
#include "ui/properties/driven_field.h"
#include "ui/properties/number_edit.h"
#include "ui/properties/triple_row.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QToolButton>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace fff::ui {

namespace {

struct PlaceGroupTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::PlaceGroup)
};

constexpr LengthEdit::Range kPositionRange{-kMaxCoordinate, kMaxCoordinate, 0.1, 2, 2};
constexpr NumberEdit::Range kAngleRange{10.0, 170.0, 0.5, 0, 2};
constexpr NumberEdit::Range kNormalRange{-1.0, 1.0, 0.05, 0, 3};
/// What is shown of numbers is no finer: values that differ by less are one.
constexpr double kSameNumber = 1e-7;

bool isSameLine(const MirrorAxis &a, const MirrorAxis &b)
{
    return std::abs(cross(a.direction, b.direction)) < kPracticallyParallel &&
           std::abs(a.height(b.point)) < kEqualEnds;
}

/// Across what it is symmetric; empty where it is not, or where that has no name.
QString wordsOfSymmetry(const Section &section, const Document &document)
{
    const MirrorAxis *axis = symmetryOf(section);
    if (!axis)
        return {};
    const auto slit = slitAxis(ContourTarget::redraw(section), document);
    if (slit && isSameLine(*slit, *axis))
        return PlaceGroupTexts::tr("across its slit");
    if (isLevel(section.frame))
        return {};
    const Vec2 up = Vec2(section.frame.x.y(), section.frame.y.y()).normalized();
    if (std::abs(cross(up, axis->direction)) < kPracticallyParallel)
        return PlaceGroupTexts::tr("across the vertical");
    return std::abs(up.dot(axis->direction)) < kPracticallyParallel
               ? PlaceGroupTexts::tr("across the horizontal")
               : QString();
}

} // namespace

PlaceGroup::PlaceGroup(Workbench &bench, QWidget *parent)
    : PropertyGroup(PlaceGroupTexts::tr("Place"), parent), m_bench(bench)
{
    addParent();
    addAngle();
    addHolding();
    addPosition();
    addNormal();
    addSwitch(PlaceGroupTexts::tr("Free"), "sectionFree",
              PlaceGroupTexts::tr(
                  "It neither moves with the section that it is on, nor keeps its angle to it"),
              "section.free",
              [](const Section &section) { return section.parent && section.parent->isFree; });
    addSwitch(PlaceGroupTexts::tr("Locked"), "sectionLocked",
              PlaceGroupTexts::tr("It stays as it is, unless the section that it is on moves"),
              "section.lock", [](const Section &section) { return section.isLocked; });
    addSwitch(
        PlaceGroupTexts::tr("Symmetric"), "sectionSymmetric",
        PlaceGroupTexts::tr("Changes to points of one half apply to the other"),
        "section.symmetric", [](const Section &section) { return symmetryOf(section) != nullptr; },
        [this] { return symmetryWords(); });
}

/// Across what; empty where that is not one thing, or nothing that has a name.
QString PlaceGroup::symmetryWords() const
{
    QStringList words;
    for (const Section *section : sections())
        words += wordsOfSymmetry(*section, m_bench.session().model().document);
    return words.count(words.value(0)) == words.size() ? words.value(0) : QString();
}

void PlaceGroup::add(PropertyRow *row)
{
    PropertyGroup::add(row);
    m_rows.push_back(row);
}

std::vector<const Section *> PlaceGroup::sections() const
{
    const Model &model = m_bench.session().model();
    std::vector<const Section *> all;
    for (const SectionRef &ref : m_bench.interaction().selection())
        if (const Section *section = model.find(ref))
            all.push_back(section);
    return all;
}

const Section *PlaceGroup::parentOf(const Section &section) const
{
    return section.parent ? m_bench.session().model().find(section.parent->section) : nullptr;
}

/// Nothing where they differ, or where one has no such number.
std::optional<double>
PlaceGroup::common(const std::function<std::optional<double>(const Section &)> &valueOf) const
{
    std::optional<double> first;
    for (const Section *section : sections()) {
        const std::optional<double> value = valueOf(*section);
        if (!value || (first && std::abs(*first - *value) > kSameNumber))
            return std::nullopt;
        first = first ? first : value;
    }
    return first;
}

void PlaceGroup::addParent()
{
    auto *row = new TextRow(
        PlaceGroupTexts::tr("On"), "sectionParent",
        [this] {
            QStringList names;
            for (const Section *section : sections()) {
                const Section *on = parentOf(*section);
                names += on ? QString::fromStdString(on->name) : PlaceGroupTexts::tr("nothing");
                m_off->setVisible(on && sections().size() == 1);
            }
            m_pick->setVisible(names.size() == 1);
            const bool isCommon = names.count(names.value(0)) == names.size();
            return isCommon ? names.value(0) : QString();
        },
        this);
    m_pick = row->addButton(QStringLiteral("pick"), "sectionParentPick",
                            PlaceGroupTexts::tr("Click another section to put it on"),
                            [this] { m_bench.run(QStringLiteral("section.putOn")); });
    m_off = row->addButton(QStringLiteral("close"), "sectionParentNone",
                           PlaceGroupTexts::tr("Not on another section"), [this] {
                               m_bench.run(QStringLiteral("section.putOn"), {{"on", ""}});
                           });
    add(row);
}

void PlaceGroup::addAngle()
{
    auto *edit = new NumberEdit(kAngleRange, PlaceGroupTexts::tr("°"), this);
    connect(edit, &NumberEdit::numberEdited, this, [this](double value) {
        m_bench.editSections(withAngle(m_bench.session().committed(),
                                       m_bench.interaction().selection(), radians(value),
                                       m_bench.interaction().settings().takesChildren));
    });
    edit->setFollowed(
        followedAt(m_bench, selectedSectionPlace(m_bench, DrivenPlace::Of::Section, "angle")));
    m_angle = new EditorRow(
        PlaceGroupTexts::tr("Angle to it"), "sectionAngle", edit,
        [this, edit] {
            const auto angle = [this](const Section &section) -> std::optional<double> {
                const Section *on = parentOf(section);
                return on ? std::optional(degrees(angleToParent(section, on->frame)))
                          : std::nullopt;
            };
            const std::vector<const Section *> all = sections();
            m_angle->setVisible(std::any_of(all.begin(), all.end(), [this](const Section *section) {
                return parentOf(*section) != nullptr;
            }));
            edit->setNumber(common(angle));
        },
        this);
    add(m_angle);
}

/// Only where what it is on is stretched by values: else there is nothing to follow.
void PlaceGroup::addHolding()
{
    PropertyRow *row = new ChoiceRow(
        PlaceGroupTexts::tr("Follows"), "sectionHoldsTo",
        [this] {
            Choices choices;
            for (const QString &name :
                 {PlaceGroupTexts::tr("in proportion"), PlaceGroupTexts::tr("its left end"),
                  PlaceGroupTexts::tr("its right end"), PlaceGroupTexts::tr("its lower end"),
                  PlaceGroupTexts::tr("its upper end")})
                choices.all.push_back({name, QColor()});
            std::set<HoldsTo> ends;
            for (const Section *section : sections())
                if (section->parent)
                    ends.insert(section->parent->holdsTo);
            if (ends.size() == 1)
                choices.current = static_cast<int>(*ends.begin());
            return choices;
        },
        [this](int index) {
            m_bench.run(QStringLiteral("section.holdTo"),
                        {{"end", std::string(nameIn(kHoldsToNames, static_cast<HoldsTo>(index)))}});
        },
        this);
    row->setToolTip(PlaceGroupTexts::tr(
        "How its place follows when a value stretches the section that it is on: as far as that is "
        "stretched there, or at its distance from an end"));
    m_holding = row;
    add(row);
}

/// Of the middle of its shape.
void PlaceGroup::addPosition()
{
    const std::array names{"positionX", "positionY", "positionZ"};
    const char *const keys[] = {"x", "y", "z"};
    std::array<NumberEdit *, 3> edits{};
    for (int axis : {0, 1, 2}) {
        auto *edit = new LengthEdit(kPositionRange, this);
        edit->setObjectName(QLatin1String(names[static_cast<std::size_t>(axis)]));
        edit->setThickness([this] {
            const Document &document = m_bench.session().model().document;
            return common([&document](const Section &section) {
                return std::optional(document.stockOf(section).thickness);
            });
        });
        connect(edit, &LengthEdit::lengthEdited, this, [this, axis](double value) {
            m_bench.editSections(withPosition(m_bench.session().committed(),
                                              m_bench.interaction().selection(), axis, value,
                                              m_bench.interaction().settings().takesChildren));
            refresh(); // a refused value goes back to what it was
        });
        edit->setFollowed(followedAt(
            m_bench, selectedSectionPlace(m_bench, DrivenPlace::Of::Section, keys[axis])));
        edits[static_cast<std::size_t>(axis)] = edit;
    }
    add(new TripleRow(
        PlaceGroupTexts::tr("Position"), edits,
        {PlaceGroupTexts::tr("X of its middle"), PlaceGroupTexts::tr("Y of its middle"),
         PlaceGroupTexts::tr("Z of its middle")},
        [this](int axis) {
            return common([axis](const Section &section) {
                return std::optional(positionOf(section)[axis]);
            });
        },
        this));
}

/// Across its plane, of length 1.
void PlaceGroup::addNormal()
{
    const std::array names{"normalX", "normalY", "normalZ"};
    std::array<NumberEdit *, 3> edits{};
    for (int axis : {0, 1, 2}) {
        auto *edit = new NumberEdit(kNormalRange, QString(), this);
        edit->setObjectName(QLatin1String(names[static_cast<std::size_t>(axis)]));
        connect(edit, &NumberEdit::numberEdited, this, [this, axis](double value) {
            m_bench.editSections(withNormal(m_bench.session().committed(),
                                            m_bench.interaction().selection(), axis, value,
                                            m_bench.interaction().settings().takesChildren));
        });
        edits[static_cast<std::size_t>(axis)] = edit;
    }
    add(new TripleRow(
        PlaceGroupTexts::tr("Direction"), edits,
        {PlaceGroupTexts::tr("X of the direction it faces, of length 1"),
         PlaceGroupTexts::tr("Y of the direction it faces, of length 1"),
         PlaceGroupTexts::tr("Z of the direction it faces, of length 1")},
        [this](int axis) {
            return common([axis](const Section &section) {
                return std::optional(section.frame.normal()[axis] + 0.0); // no minus before a zero
            });
        },
        this));
}

void PlaceGroup::addSwitch(const QString &name, const char *objectName, const QString &tip,
                           const char *command, std::function<bool(const Section &)> read,
                           std::function<QString()> words)
{
    auto *box = new QCheckBox(this);
    const QString id = QLatin1String(command);
    connect(box, &QCheckBox::clicked, this, [this, id, box] {
        m_bench.run(id, {{"on", box->isChecked() ? "true" : "false"}});
    });
    auto *row = new EditorRow(
        name, objectName, box,
        [this, box, id, tip, read = std::move(read), words = std::move(words)] {
            if (words)
                box->setText(words());
            const std::vector<const Section *> all = sections();
            const auto on = std::count_if(all.begin(), all.end(),
                                          [&read](const Section *s) { return read(*s); });
            box->setTristate(on > 0 && on < std::ssize(all));
            box->setCheckState(on == 0                 ? Qt::Unchecked
                               : on == std::ssize(all) ? Qt::Checked
                                                       : Qt::PartiallyChecked);
            const WhyNot whyNot = m_bench.commands().whyNot(id.toStdString());
            box->setEnabled(!whyNot);
            box->parentWidget()->setToolTip(whyNot ? messageText(*whyNot) : tip);
            box->setAccessibleDescription(box->parentWidget()->toolTip());
        },
        this);
    row->setToolTip(tip);
    add(row);
}

void PlaceGroup::refresh()
{
    const Model &model = m_bench.session().model();
    const std::vector<SectionRef> &selected = m_bench.interaction().selection();
    setVisible(std::all_of(selected.begin(), selected.end(), [&model](const SectionRef &ref) {
        return originOf(model, ref).has_value();
    }));
    for (PropertyRow *row : m_rows)
        row->refresh();
    const std::vector<const Section *> all = sections();
    m_holding->setVisible(std::any_of(all.begin(), all.end(), [&model](const Section *section) {
        return section->parent &&
               (section->parent->holdsTo != HoldsTo::Proportion ||
                isStretchedByValues(model.document, section->parent->section.drawn));
    }));
}

} // namespace fff::ui
