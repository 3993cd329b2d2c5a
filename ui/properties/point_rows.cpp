#include "ui/properties/point_rows.h"

#include "core/base/tolerances.h"
#include "core/base/units.h"
#include "core/interaction/point_words.h"
#include "core/model/origin.h"
#include "ui/bench/workbench.h"

#include <QCoreApplication>

#include <cmath>

namespace fff::ui {

namespace {

struct PointGroupTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::PointGroup)
};

constexpr LengthEdit::Range kPlaces{-kMaxCoordinate, kMaxCoordinate, 0.1, 2, 2};
constexpr LengthEdit::Range kLengths{0.0, kMaxCoordinate, 0.1, 2, 2};
constexpr NumberEdit::Range kAngles{-360.0, 360.0, 1.0, 1, 1};
/// Values that differ by less are one to whoever reads them.
constexpr double kSameValue = 1e-9;

Vec2 arm(const Contour &contour, int index, HandleSide side)
{
    return handle(contour, index, side) - anchor(contour, index);
}

/// Degrees, counter-clockwise from the frame's x; 0 for a handle that is none.
double angleOf(const Vec2 &arm)
{
    return arm.norm() > kNoHandle ? degrees(std::atan2(arm.y(), arm.x())) + 0.0 : 0.0;
}

Vec2 polar(double length, double angle)
{
    return length * Vec2(std::cos(radians(angle)), std::sin(radians(angle)));
}

} // namespace

PointGroup::PointGroup(Workbench &bench, QWidget *parent)
    : PropertyGroup(PointGroupTexts::tr("Point"), parent), m_bench(bench)
{
    setObjectName(QStringLiteral("pointGroup"));
    addPlaces();
    addKind();
    addHandle(HandleSide::In, PointGroupTexts::tr("Handle in"), PointGroupTexts::tr("Angle in"));
    addHandle(HandleSide::Out, PointGroupTexts::tr("Handle out"), PointGroupTexts::tr("Angle out"));
}

void PointGroup::add(PropertyRow *row)
{
    PropertyGroup::add(row);
    m_rows.push_back(row);
}

std::optional<double>
PointGroup::common(const std::function<double(const Contour &, int)> &valueOf) const
{
    // Of what is shown: a drag is seen in the numbers.
    const PointSelection &points = m_bench.interaction().points();
    const std::vector<SectionRef> &selected = m_bench.interaction().selection();
    const SectionPointer section =
        selected.size() == 1 ? editedSection(m_bench.session().model(), selected.front()) : nullptr;
    std::optional<double> value;
    for (const PointAddress &point : points.points()) {
        if (!section || !isPoint(*section->shape, point))
            return std::nullopt;
        const double here = valueOf(boundary(*section->shape, point.boundary), point.index);
        if (value && std::abs(*value - here) > kSameValue)
            return std::nullopt;
        value = value.value_or(here);
    }
    return value;
}

void PointGroup::edit(const std::function<Result<Contour>(const Contour &, int)> &change,
                      bool moves)
{
    const PointSelection points = m_bench.interaction().points();
    const Document document = m_bench.interaction().documentOfPoints();
    const Section *section = document.find(points.section());
    if (!section)
        return;
    std::vector<Vec2> places; // where they are afterwards
    const Result<ShapePointer> shape =
        withEach(*section->shape, points.points(), [&](const Contour &contour, int index) {
            Result<Contour> next = change(contour, index);
            if (next)
                places.push_back(anchor(*next, index));
            return next;
        });
    Step step = ofParts(moves ? steps::kMovePoints : steps::kChangePoints, section->name,
                        points.points().size());
    m_bench.editPoints(withEditedShape(document, section->id, shape, places, std::move(step),
                                       m_bench.interaction().pointRules()));
}

void PointGroup::addPlaces()
{
    for (const int axis : {0, 1}) {
        add(new LengthRow(
            axis == 0 ? PointGroupTexts::tr("X") : PointGroupTexts::tr("Y"),
            axis == 0 ? "pointX" : "pointY", kPlaces,
            [this, axis] {
                return common([axis](const Contour &contour, int index) {
                    return anchor(contour, index)[axis];
                });
            },
            [this, axis](double value) {
                edit(
                    [axis, value](const Contour &contour, int index) {
                        Vec2 to = anchor(contour, index);
                        to[axis] = value;
                        return movedAnchor(contour, index, to);
                    },
                    true);
            },
            this));
    }
}

void PointGroup::addKind()
{
    add(new ChoiceRow(
        PointGroupTexts::tr("Kind"), "pointKind",
        [this] {
            Choices choices;
            // In the order of PointKind.
            for (const QString &name :
                 {PointGroupTexts::tr("Corner"), PointGroupTexts::tr("Smooth"),
                  PointGroupTexts::tr("Symmetric")})
                choices.all.push_back({name, QColor()});
            const auto kind = common([](const Contour &contour, int index) {
                return static_cast<double>(kindOf(contour, index));
            });
            choices.current = kind ? static_cast<int>(*kind) : -1;
            return choices;
        },
        [this](int kind) {
            edit([kind](const Contour &contour, int index) {
                return withKind(contour, index, static_cast<PointKind>(kind));
            });
        },
        this));
}

void PointGroup::addHandle(HandleSide side, const QString &length, const QString &angle)
{
    const bool isIn = side == HandleSide::In;
    add(new LengthRow(
        length, isIn ? "handleInLength" : "handleOutLength", kLengths,
        [this, side] {
            return common([side](const Contour &contour, int index) {
                return arm(contour, index, side).norm();
            });
        },
        [this, side](double value) {
            edit([side, value](const Contour &contour, int index) {
                const Vec2 to =
                    anchor(contour, index) + polar(value, angleOf(arm(contour, index, side)));
                return movedHandle(contour, index, side, to, false);
            });
        },
        this));
    auto *field = new NumberEdit(kAngles, QStringLiteral("°"), this);
    auto *row = new EditorRow(
        angle, isIn ? "handleInAngle" : "handleOutAngle", field,
        [this, side, field] {
            field->setNumber(common([side](const Contour &contour, int index) {
                return angleOf(arm(contour, index, side));
            }));
        },
        this);
    connect(field, &NumberEdit::numberEdited, this, [this, side, row](double value) {
        edit([side, value](const Contour &contour, int index) {
            const Vec2 to = anchor(contour, index) + polar(arm(contour, index, side).norm(), value);
            return movedHandle(contour, index, side, to, false);
        });
        row->refresh(); // a refused value goes back to what it was
    });
    add(row);
}

void PointGroup::refresh()
{
    const bool hasPoints = !m_bench.interaction().points().isEmpty();
    setVisible(hasPoints);
    if (!hasPoints)
        return;
    for (PropertyRow *row : m_rows)
        row->refresh();
}

} // namespace fff::ui
