#include "ui/properties/figure_group.h"

#include "core/base/tolerances.h"
#include "core/base/units.h"
#include "core/interaction/figure_editing.h"
#include "core/model/origin.h"
#include "core/model/point_edits.h"
#include "ui/bench/workbench.h"
#include "ui/properties/driven_field.h"
#include "ui/properties/number_edit.h"

#include <QCoreApplication>
#include <QLayout>

#include <cmath>

namespace fff::ui {

namespace {

struct FigureGroupTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::FigureGroup)
};

constexpr LengthEdit::Range kPlace{-kMaxCoordinate, kMaxCoordinate, 0.1, 2, 2};
constexpr NumberEdit::Range kTurn{-360.0, 360.0, 1.0, 0, 2};

QString figureText(const char *text)
{
    return QCoreApplication::translate("Figure", text);
}

} // namespace

FigureGroup::FigureGroup(Workbench &bench, QWidget *parent)
    : PropertyGroup(FigureGroupTexts::tr("Shape"), parent), m_bench(bench),
      m_numbers(new PropertyGroup({}, this)), m_rows(*m_numbers)
{
    addKind();
    m_numbers->layout()->setContentsMargins(0, 0, 0, 0);
    add(m_numbers);
}

const Section *FigureGroup::section() const
{
    const std::vector<SectionRef> &selected = m_bench.interaction().selection();
    const Model &model = m_bench.session().model();
    const std::optional<Origin> origin =
        selected.size() == 1 ? originOf(model, selected.front()) : std::nullopt;
    return origin ? origin->section : nullptr;
}

std::optional<Figure> FigureGroup::figure(int boundary) const
{
    const Section *of = section();
    const Figure *found = of ? figureOf(*of, boundary) : nullptr;
    return found ? std::optional(*found) : std::nullopt;
}

void FigureGroup::change(int boundary, const std::function<void(Figure &)> &change)
{
    std::optional<Figure> next = figure(boundary);
    if (!next)
        return;
    change(*next);
    m_bench.editSections(changedFigure(m_bench.session().committed(),
                                       m_bench.interaction().selection().front(), boundary, *next));
}

/// Of the contour. By hand it becomes so by being edited, not by being called so.
void FigureGroup::addKind()
{
    m_kind = new ChoiceRow(
        FigureGroupTexts::tr("Contour"), "figureKind",
        [this] {
            Choices choices;
            const std::optional<Figure> now = figure(0);
            choices.all.push_back(
                {FigureGroupTexts::tr("Free form"), QColor(),
                 now ? FigureGroupTexts::tr("Moving one of its points makes it so") : QString()});
            choices.current = 0;
            for (const FigureKind &kind : figureKinds()) {
                if (now && now->kind == kind.key)
                    choices.current = static_cast<int>(choices.all.size());
                choices.all.push_back({figureText(kind.name), QColor()});
            }
            return choices;
        },
        [this](int index) {
            const auto kinds = figureKinds();
            if (index > 0)
                m_bench.editSections(figureContour(m_bench.session().committed(),
                                                   m_bench.interaction().selection().front(),
                                                   kinds[static_cast<std::size_t>(index) - 1]));
        },
        this);
    add(m_kind);
}

Followed FigureGroup::followedOf(int boundary, const char *field) const
{
    return followedAt(m_bench,
                      selectedSectionPlace(m_bench, DrivenPlace::Of::Figure, field, boundary));
}

void FigureGroup::addNumber(int boundary, const FigureKind &kind, std::size_t index)
{
    const FigureNumber &number = kind.numbers[index];
    const QString name = QStringLiteral("figure%1.%2").arg(boundary).arg(QLatin1String(number.key));
    const auto read = [this, boundary, index]() -> std::optional<double> {
        const std::optional<Figure> now = figure(boundary);
        return now && index < now->numbers.size() ? std::optional(now->numbers[index])
                                                  : std::nullopt;
    };
    const auto write = [this, boundary, index](double value) {
        change(boundary, [index, value](Figure &figure) { figure.numbers[index] = value; });
    };
    const Followed followed = followedOf(boundary, number.key);
    if (number.unit == FigureNumber::Unit::Length) {
        auto *row = new LengthRow(figureText(number.label), name.toLatin1().constData(),
                                  {number.least, number.most, 0.5, 1, 2}, read, write, this);
        row->setThickness([this]() -> std::optional<double> {
            const Section *of = section();
            return of ? std::optional(m_bench.session().model().document.stockOf(*of).thickness)
                      : std::nullopt;
        });
        row->setFollowed(followed);
        m_rows.add(row);
        return;
    }
    auto *edit = new NumberEdit({number.least, number.most, 1.0, 0, 0}, QString(), this);
    edit->setFollowed(followed);
    connect(edit, &NumberEdit::numberEdited, this,
            [write](double value) { write(std::round(value)); });
    m_rows.add(new EditorRow(
        figureText(number.label), name.toLatin1().constData(), edit,
        [edit, read] { edit->setNumber(read()); }, this));
}

void FigureGroup::addPlace(int boundary, int axis, const QString &name)
{
    const QString id = QStringLiteral("figure%1.%2").arg(boundary).arg(QLatin1Char("xy"[axis]));
    auto *row = new LengthRow(
        name, id.toLatin1().constData(), kPlace,
        [this, boundary, axis]() -> std::optional<double> {
            const std::optional<Figure> now = figure(boundary);
            return now ? std::optional(now->centre[axis]) : std::nullopt;
        },
        [this, boundary, axis](double value) {
            change(boundary, [axis, value](Figure &figure) { figure.centre[axis] = value; });
        },
        this);
    row->setFollowed(followedOf(boundary, axis == 0 ? "centreX" : "centreY"));
    row->setToolTip(FigureGroupTexts::tr("Its centre, in the coordinates of the section"));
    m_rows.add(row);
}

void FigureGroup::addTurn(int boundary)
{
    auto *edit = new NumberEdit(kTurn, FigureGroupTexts::tr("°"), this);
    connect(edit, &NumberEdit::numberEdited, this, [this, boundary](double value) {
        change(boundary, [value](Figure &figure) { figure.turn = radians(value); });
    });
    edit->setFollowed(followedOf(boundary, "turn"));
    const QString id = QStringLiteral("figure%1.turn").arg(boundary);
    m_rows.add(new EditorRow(
        FigureGroupTexts::tr("Turned by"), id.toLatin1().constData(), edit,
        [this, edit, boundary] {
            const std::optional<Figure> now = figure(boundary);
            edit->setNumber(now ? std::optional(degrees(now->turn)) : std::nullopt);
        },
        this));
}

void FigureGroup::addNumbers(int boundary, const FigureKind &kind)
{
    if (boundary > 0) {
        //: %1 is a number
        const QString title = FigureGroupTexts::tr("Hole %1").arg(boundary);
        const QString text = figureText(kind.name);
        const QString id = QStringLiteral("figure%1").arg(boundary);
        m_rows.add(new TextRow(
            title, id.toLatin1().constData(), [text] { return text; }, this));
    }
    for (std::size_t i = 0; i < kind.numbers.size(); ++i)
        addNumber(boundary, kind, i);
    if (boundary > 0) {
        addPlace(boundary, 0, FigureGroupTexts::tr("X"));
        addPlace(boundary, 1, FigureGroupTexts::tr("Y"));
    }
    if (std::string_view(kind.key) != "circle")
        addTurn(boundary);
}

/// The rows are others only where the figures are of other kinds.
void FigureGroup::rebuild(const Section &section)
{
    QString built;
    for (int i = 0; i < boundaryCount(*section.shape); ++i)
        if (const Figure *figure = figureOf(section, i))
            built += QStringLiteral("%1 %2 ").arg(i).arg(QString::fromStdString(figure->kind));
    if (!m_rows.become(built))
        return;
    for (int i = 0; i < boundaryCount(*section.shape); ++i)
        if (const Figure *figure = figureOf(section, i))
            addNumbers(i, *figureKind(figure->kind));
}

void FigureGroup::refresh()
{
    const Section *of = section();
    m_kind->setVisible(of != nullptr);
    m_numbers->setVisible(of && !of->figures.empty());
    if (!of)
        return;
    rebuild(*of);
    m_kind->refresh();
    m_rows.refresh();
}

} // namespace fff::ui
