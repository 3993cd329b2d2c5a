#include "ui/docks/load_page.h"

#include "core/base/tolerances.h"
#include "core/interaction/load_editing.h"
#include "core/interaction/load_marks.h"
#include "core/model/load_edits.h"
#include "ui/base/icon.h"
#include "ui/bench/workbench.h"
#include "ui/properties/driven_field.h"
#include "ui/properties/load_presets.h"
#include "ui/properties/mass_edit.h"
#include "ui/properties/property_rows.h"
#include "ui/properties/slider_field.h"

#include <QCheckBox>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace fff::ui {

namespace {

constexpr double kGramsOfKilogram = 1000.0;
constexpr NumberEdit::Range kLoadMass{0.001, kGramsOfKilogram *kMaxWeight, 10.0, 0, 3}; // g
constexpr NumberEdit::Range kWaterRange{0.0, 1e4, 10.0, 0, 1};                          // ml
constexpr NumberEdit::Range kPushForce{0.001, kMaxPush, 0.5, 0, 3};                     // N
constexpr NumberEdit::Range kDirectionPart{-1.0, 1.0, 0.1, 0, 4};
constexpr LengthEdit::Range kSpreadWidth{kLeastSpread, kMostSpread, 1.0, 1, 3};
constexpr LengthEdit::Range kCentreHeight{0.0, kMostSpread, 1.0, 1, 3};
constexpr LengthEdit::Range kLoadPlace{-kMaxCoordinate, kMaxCoordinate, 0.5, 1, 3};
constexpr int kWaterField = 92; // px: beside its slider
/// A direction that is less than this is none.
constexpr double kNoWay = 1e-9;

constexpr Spread kSpreads[] = {Spread::Point, Spread::Patch, Spread::Edge, Spread::Hanging};

void setForce(Load &load, double force)
{
    load.push *= force / load.push.norm();
}

/// With what it holds, the vessel as heavy as it is.
void fill(Load &load, double millilitres)
{
    const double vessel = load.mass - load.filled;
    load.filled = millilitres / kGramsOfKilogram;
    load.mass = vessel + load.filled;
}

} // namespace

LoadPage::LoadPage(Workbench &bench, QWidget *parent) : QWidget(parent), m_bench(bench)
{
    m_weight = new PropertyGroup(tr("Weight"), this);
    m_push = new PropertyGroup(tr("Push"), this);
    auto *spread = new PropertyGroup(tr("Where it acts"), this);
    addWeightRows(m_weight);
    addPushRows(m_push);
    addPlaceRows(spread);
    addSpreadRows(spread);
    auto *remove = new QPushButton(themedIcon(QStringLiteral("trash")), tr("Remove"), this);
    remove->setObjectName(QStringLiteral("loadRemove"));
    remove->setAutoDefault(false);
    connect(remove, &QPushButton::clicked, this,
            [this] { m_bench.run(QStringLiteral("physics.removeLoad")); });

    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    for (QWidget *group : {static_cast<QWidget *>(m_weight), static_cast<QWidget *>(m_push),
                           static_cast<QWidget *>(spread)})
        column->addWidget(group);
    column->addSpacing(8);
    column->addWidget(remove, 0, Qt::AlignLeft);
}

PropertyRow *LoadPage::add(PropertyGroup *group, PropertyRow *row, std::function<bool()> isWanted)
{
    group->add(row);
    m_rows.push_back({row, std::move(isWanted)});
    return row;
}

Followed LoadPage::followedOf(const char *field)
{
    return followedAt(m_bench, [this, field] {
        return std::optional(
            DrivenPlace{.of = DrivenPlace::Of::Load, .id = m_load.id.value, .field = field});
    });
}

PropertyRow *LoadPage::lengthRow(const QString &name, const char *objectName,
                                 const NumberEdit::Range &range, const char *field,
                                 std::function<double &(Load &)> in, PropertyGroup *group)
{
    auto *row = new LengthRow(
        name, objectName, range,
        [this, in]() -> std::optional<double> {
            Load copy = load();
            return in(copy);
        },
        [this, in](double value) { change([&](Load &load) { in(load) = value; }); }, group);
    row->setFollowed(followedOf(field));
    return row;
}

void LoadPage::addWeightRows(PropertyGroup *group)
{
    const auto always = [] { return true; };
    add(group,
        new ChoiceRow(
            tr("Object"), "loadPreset",
            [this] {
                Choices choices;
                choices.all.push_back({tr("Plain weight"), QColor()});
                choices.current = 0;
                for (const LoadPreset &preset : loadPresets()) {
                    choices.all.push_back({preset.name, QColor()});
                    if (preset.key == load().preset)
                        choices.current = static_cast<int>(choices.all.size()) - 1;
                }
                return choices;
            },
            [this](int index) {
                change([index](Load &load) {
                    if (index > 0)
                        load = taken(loadPresets()[static_cast<std::size_t>(index - 1)], load);
                    else
                        load.preset.clear();
                });
            },
            group),
        always);
    auto *mass = new MassEdit(kLoadMass, group);
    connect(mass, &NumberEdit::numberEdited, this, [this](double grams) {
        change([grams](Load &load) {
            load.mass = grams / kGramsOfKilogram;
            load.filled = std::min(load.filled, load.mass);
        });
    });
    mass->setFollowed(followedOf("mass"));
    add(group,
        new EditorRow(
            tr("Mass"), "loadMass", mass,
            [this, mass] { mass->setNumber(kGramsOfKilogram * load().mass); }, group),
        always)
        ->setToolTip(tr("Also in kg, oz or lb: 1.5 kg, 2 lb"));
    auto *field = new NumberEdit(kWaterRange, tr("ml"));
    field->setFixedWidth(kWaterField);
    m_water = new SliderField({0.0, 0.0, 10.0, 5}, field, group);
    m_water->setNames("loadWaterSlider", "loadWater.field");
    connect(m_water, &SliderField::dragged, this, [this](double millilitres) {
        preview([millilitres](Load &load) { fill(load, millilitres); });
    });
    connect(m_water, &SliderField::settled, this, [this](double millilitres) {
        change([millilitres](Load &load) { fill(load, millilitres); });
    });
    connect(m_water, &SliderField::cancelled, this, [this] { m_bench.session().cancelPreview(); });
    add(group,
        new EditorRow(
            tr("Water in it"), "loadWater", m_water,
            [this] {
                if (const LoadPreset *preset = loadPreset(load().preset))
                    m_water->setMost(kGramsOfKilogram * preset->holds);
                m_water->setNumber(kGramsOfKilogram * load().filled);
            },
            group),
        [this] {
            const LoadPreset *preset = loadPreset(load().preset);
            return preset && preset->holds > 0.0;
        });
    add(group,
        lengthRow(
            tr("Centre of mass"), "loadHeight", kCentreHeight, "height",
            [](Load &load) -> double & { return load.height; }, group),
        [this] { return load().spread != Spread::Hanging; })
        ->setToolTip(tr("Height above its place: the higher, the sooner the model tips over"));
}

void LoadPage::addPushRows(PropertyGroup *group)
{
    auto *force = new NumberEdit(kPushForce, tr("N"), group);
    connect(force, &NumberEdit::numberEdited, this,
            [this](double newtons) { change([newtons](Load &load) { setForce(load, newtons); }); });
    add(group,
        new EditorRow(
            tr("Force"), "loadForce", force,
            [this, force] { force->setNumber(load().push.norm()); }, group),
        [] { return true; })
        ->setToolTip(tr("10 N is about as much as 1 kg weighs"));
    addDirection(group, 0, tr("Direction X"), "loadDirectionX");
    addDirection(group, 1, tr("Direction Y"), "loadDirectionY");
    addDirection(group, 2, tr("Direction Z"), "loadDirectionZ");
}

void LoadPage::addDirection(PropertyGroup *group, int axis, const QString &name,
                            const char *objectName)
{
    auto *part = new NumberEdit(kDirectionPart, QString(), group);
    const auto direction = [this](const Load &load) -> Vec3 {
        const Section *section = m_bench.session().model().find(load.section);
        return section ? pushInWorld(load.push, section->frame).normalized() : Vec3::UnitY();
    };
    connect(part, &NumberEdit::numberEdited, this, [this, axis, direction](double value) {
        change([this, axis, value, direction](Load &load) {
            const Section *section = m_bench.session().model().find(load.section);
            Vec3 way = direction(load);
            way[axis] = value;
            if (section && way.norm() > kNoWay)
                load.push = pushInFrame(load.push.norm() * way.normalized(), section->frame);
        });
    });
    add(group,
        new EditorRow(
            name, objectName, part,
            [this, part, axis, direction] {
                part->setNumber(direction(load())[axis] + 0.0); // no minus before a zero
            },
            group),
        [] { return true; });
}

void LoadPage::addPlaceRows(PropertyGroup *group)
{
    const auto always = [] { return true; };
    add(group,
        new TextRow(
            tr("On"), "loadSection",
            [this] {
                return QString::fromStdString(m_bench.session().model().nameOf(load().section));
            },
            group),
        always);
    const auto addPlace = [&](int axis, const QString &name, const char *objectName) {
        add(group,
            lengthRow(
                name, objectName, kLoadPlace, axis == 0 ? "x" : "y",
                [axis](Load &load) -> double & { return load.position[axis]; }, group),
            always)
            ->setToolTip(tr("In the section's own plane, from its origin"));
    };
    addPlace(0, tr("Place X"), "loadX");
    addPlace(1, tr("Place Y"), "loadY");
}

void LoadPage::addSpreadRows(PropertyGroup *group)
{
    add(group,
        new ChoiceRow(
            tr("Spread"), "loadSpread",
            [this] {
                Choices choices;
                for (const QString &name :
                     {tr("At a point"), tr("Over a patch"), tr("Along the edge"), tr("Hanging")})
                    choices.all.push_back({name, QColor()});
                if (load().isPush())
                    choices.all.pop_back();
                choices.current = static_cast<int>(
                    std::find(std::begin(kSpreads), std::end(kSpreads), load().spread) -
                    std::begin(kSpreads));
                return choices;
            },
            [this](int index) { change([index](Load &load) { load.spread = kSpreads[index]; }); },
            group),
        [] { return true; });
    add(group,
        lengthRow(
            tr("Width"), "loadWidth", kSpreadWidth, "width",
            [](Load &load) -> double & { return load.width; }, group),
        [this] { return load().spread == Spread::Patch || load().spread == Spread::Edge; });
    auto *repeated = new QCheckBox(group);
    connect(repeated, &QCheckBox::clicked, this,
            [this](bool isOn) { change([isOn](Load &load) { load.isRepeated = isOn; }); });
    add(group,
        new EditorRow(
            tr("On copies too"), "loadRepeated", repeated,
            [this, repeated] { repeated->setChecked(load().isRepeated); }, group),
        [this] { return hasCopies(); })
        ->setToolTip(tr("Copies that operations make of its section carry one each"));
}

bool LoadPage::hasCopies() const
{
    const Model &model = m_bench.session().model();
    for (std::size_t i = model.drawnCount(); i < model.sectionCount(); ++i)
        for (const CopyOf *copy = model.section(i)->copyOf ? &*model.section(i)->copyOf : nullptr;
             copy; copy = copy->before.get())
            if (copy->section == load().section)
                return true;
    return false;
}

void LoadPage::change(const std::function<void(Load &)> &change)
{
    const Load *committed = m_bench.session().committed().document.find(m_load.id);
    if (!committed)
        return;
    Load next = *committed;
    change(next);
    if (next == *committed) {
        m_bench.session().cancelPreview();
        return;
    }
    SectionEdit edit = changedLoad(m_bench.session().committed(), next);
    if (!edit)
        m_bench.session().cancelPreview();
    m_bench.editSections(std::move(edit));
    refresh(); // a refused value goes back to what it was
}

void LoadPage::preview(const std::function<void(Load &)> &change)
{
    const Document &document = m_bench.session().committed().document;
    const Load *committed = document.find(m_load.id);
    if (!committed)
        return;
    Load next = *committed;
    change(next);
    if (auto shown = setLoad(document, next))
        m_bench.session().preview(*std::move(shown));
}

void LoadPage::follow()
{
    if (m_load.id.isValid() && m_load.id != m_bench.interaction().selectedLoad()) {
        m_water->settle();
        m_load = {};
    }
}

void LoadPage::refresh()
{
    const Load *selected =
        m_bench.session().model().document.find(m_bench.interaction().selectedLoad());
    if (!selected)
        return;
    m_load = *selected;
    m_weight->setVisible(!m_load.isPush());
    m_push->setVisible(m_load.isPush());
    for (const Row &row : m_rows) {
        row.row->setVisible(row.isWanted());
        row.row->refresh();
    }
}

} // namespace fff::ui
