// Place, angle and size of sections, the numbers of their figures and of their lettering, as
// expressions can drive them.
#include "core/geometry/turning.h"
#include "core/model/edits.h"
#include "core/model/figures.h"
#include "core/model/lettering.h"
#include "core/model/marks.h"
#include "core/model/moving.h"
#include "core/model/point_edits.h"
#include "core/operations/driven_owner.h"
#include "core/operations/stretched_by_numbers.h"

#include <cmath>

namespace fff {

namespace {

const Section *sectionAt(const Document &document, const DrivenPlace &place)
{
    return document.find(SectionId{place.id});
}

std::string nameOfSection(const Document &document, const DrivenPlace &place)
{
    const Section *section = sectionAt(document, place);
    return section ? section->name : std::string();
}

/// On what it was drawn, as far as that is drawn, too: what operations make is not there yet.
const Section *drawnHolderOf(const Document &document, const Section &section)
{
    return section.parent ? document.find(section.parent->section.drawn) : nullptr;
}

/// The middle of the box of its contour, in the world (mm), as the window says it.
template <int axis>
std::optional<double> readPlace(const Document &, const Section &section)
{
    return section.frame.toWorld(section.shape->bounds().center())[axis];
}

template <int axis>
Result<Document> writePlace(Document document, const Section &section, double to)
{
    Vec3 way = Vec3::Zero();
    way[axis] = to - *readPlace<axis>(document, section);
    const SectionMove moves[] = {
        {.section = section.id, .placement = Similarity::moved(way), .breaksAngle = false}};
    return movedSections(std::move(document), moves);
}

std::optional<double> readAngle(const Document &document, const Section &section)
{
    const Section *holder = drawnHolderOf(document, section);
    return holder ? std::optional(angleToParent(section, holder->frame)) : std::nullopt;
}

Result<Document> writeAngle(Document document, const Section &section, double to)
{
    const Similarity turn = turnToAngle(section, drawnHolderOf(document, section)->frame, to);
    const SectionMove moves[] = {{.section = section.id, .placement = turn, .breaksAngle = true}};
    return movedSections(std::move(document), moves);
}

template <int axis>
std::optional<double> readSize(const Document &, const Section &section)
{
    return turnedBounds(section.shape->contour(), Vec2::UnitX()).size()[axis];
}

/// About the middle of its slit, which stays where it is; without one, what is upright grows from
/// its lower end, on which it may stand, whatever its height was before, and else it is about the
/// middle of its box. Slits are no part of a contour: they keep their width.
template <int axis>
Result<Document> writeSize(Document document, const Section &section, double to)
{
    const double now = *readSize<axis>(document, section);
    if (!(to > 0.0 && now > 0.0))
        return failure(ErrorCode::BadValue, axis == 0 ? "width" : "height");
    Eigen::Matrix2d matrix = Eigen::Matrix2d::Identity();
    matrix(axis, axis) = to / now;
    const Box2 box = turnedBounds(section.shape->contour(), Vec2::UnitX());
    const Vec2 along = Vec2::Unit(axis);
    const double up = section.frame.directionToWorld(along).y();
    const Vec2 about = slitHolding(document, section, along)
                           .value_or(std::abs(up) < kUpright ? box.center()
                                     : up > 0.0              ? box.min
                                                             : box.max);
    return stretchedByNumbers(std::move(document), section, {.matrix = matrix, .about = about});
}

struct SectionField
{
    const char *key;
    Text label;
    ValueKind kind;
    std::optional<double> (*read)(const Document &document, const Section &section);
    Result<Document> (*write)(Document document, const Section &section, double to);
};

const SectionField kSectionFields[] = {
    {"x", FFF_TEXT("Driven", "X"), ValueKind::Length, readPlace<0>, writePlace<0>},
    {"y", FFF_TEXT("Driven", "Y"), ValueKind::Length, readPlace<1>, writePlace<1>},
    {"z", FFF_TEXT("Driven", "Z"), ValueKind::Length, readPlace<2>, writePlace<2>},
    {"angle", FFF_TEXT("Driven", "Angle"), ValueKind::Angle, readAngle, writeAngle},
    {"width", FFF_TEXT("Driven", "Width"), ValueKind::Length, readSize<0>, writeSize<0>},
    {"height", FFF_TEXT("Driven", "Height"), ValueKind::Length, readSize<1>, writeSize<1>},
};

std::optional<DrivenNumber> readSection(const Document &document, const DrivenPlace &place)
{
    const Section *section = sectionAt(document, place);
    const SectionField *field = fieldNamed(kSectionFields, place.field);
    const std::optional<double> number =
        section && field ? field->read(document, *section) : std::nullopt;
    if (!number)
        return std::nullopt;
    return DrivenNumber{field->kind, worthOf(field->kind, *number), field->label};
}

Result<Document> writeSection(Document document, const DrivenPlace &place, const Worth &worth)
{
    const SectionPointer section =
        document.sections[static_cast<std::size_t>(document.indexOf(SectionId{place.id}))];
    return fieldNamed(kSectionFields, place.field)
        ->write(std::move(document), *section, worth.number);
}

void listSections(const Document &document, std::vector<DrivenPlace> &places)
{
    for (const SectionPointer &section : document.sections)
        for (const SectionField &field : kSectionFields)
            if (field.read(document, *section))
                places.push_back(
                    {.of = DrivenPlace::Of::Section, .id = section->id.value, .field = field.key});
}

struct FigureField
{
    const char *key;
    Text label;
    ValueKind kind;
    double &(*in)(Figure &figure);
};

/// Besides the numbers of its kind.
const FigureField kFigureFields[] = {
    {"centreX", FFF_TEXT("Driven", "X of the centre"), ValueKind::Length,
     [](Figure &f) -> double & { return f.centre.x(); }},
    {"centreY", FFF_TEXT("Driven", "Y of the centre"), ValueKind::Length,
     [](Figure &f) -> double & { return f.centre.y(); }},
    {"turn", FFF_TEXT("Driven", "Turn"), ValueKind::Angle,
     [](Figure &f) -> double & { return f.turn; }},
};

struct NumberOfFigure
{
    double *number = nullptr; // null: it has none of that key
    ValueKind kind = ValueKind::Length;
    Text label = {};
};

NumberOfFigure numberIn(Figure &figure, const std::string &key)
{
    if (const FigureField *field = fieldNamed(kFigureFields, key))
        return {&field->in(figure), field->kind, field->label};
    const FigureKind *kind = figureKind(figure.kind);
    for (std::size_t i = 0; kind && i < kind->numbers.size() && i < figure.numbers.size(); ++i)
        if (key == kind->numbers[i].key)
            return {&figure.numbers[i],
                    kind->numbers[i].unit == FigureNumber::Unit::Count ? ValueKind::Count
                                                                       : ValueKind::Length,
                    Text{"Figure", kind->numbers[i].label}};
    return {};
}

std::optional<DrivenNumber> readFigure(const Document &document, const DrivenPlace &place)
{
    const Section *section = sectionAt(document, place);
    const Figure *figure = section ? figureOf(*section, place.index) : nullptr;
    if (!figure)
        return std::nullopt;
    Figure copy = *figure;
    const NumberOfFigure of = numberIn(copy, place.field);
    if (!of.number)
        return std::nullopt;
    return DrivenNumber{of.kind, worthOf(of.kind, *of.number), of.label};
}

Result<Document> writeFigure(Document document, const DrivenPlace &place, const Worth &worth)
{
    Figure next = *figureOf(*sectionAt(document, place), place.index);
    *numberIn(next, place.field).number = worth.number;
    return setFigure(std::move(document), SectionId{place.id}, place.index, next);
}

void listFigures(const Document &document, std::vector<DrivenPlace> &places)
{
    for (const SectionPointer &section : document.sections) {
        if (section->figures.empty())
            continue;
        for (int i = 0; i < boundaryCount(*section->shape); ++i) {
            const Figure *figure = figureOf(*section, i);
            const FigureKind *kind = figure ? figureKind(figure->kind) : nullptr;
            const auto add = [&](const char *key) {
                places.push_back({.of = DrivenPlace::Of::Figure,
                                  .id = section->id.value,
                                  .index = i,
                                  .field = key});
            };
            for (const FigureField &field : kFigureFields)
                if (kind)
                    add(field.key);
            if (kind)
                for (const FigureNumber &number : kind->numbers)
                    add(number.key);
        }
    }
}

struct LetteringField
{
    const char *key;
    Text label;
    ValueKind kind;
    double &(*in)(Lettering &lettering); // null: the text
};

const LetteringField kLetteringFields[] = {
    {"text", FFF_TEXT("Driven", "Text"), ValueKind::Text, nullptr},
    {"height", FFF_TEXT("Driven", "Height of letters"), ValueKind::Length,
     [](Lettering &l) -> double & { return l.height; }},
    {"x", FFF_TEXT("Driven", "X"), ValueKind::Length,
     [](Lettering &l) -> double & { return l.at.x(); }},
    {"y", FFF_TEXT("Driven", "Y"), ValueKind::Length,
     [](Lettering &l) -> double & { return l.at.y(); }},
    {"turn", FFF_TEXT("Driven", "Turn"), ValueKind::Angle,
     [](Lettering &l) -> double & { return l.turn; }},
};

/// Null: there is no such mark, or it is no lettering.
const Mark *letteredAt(const Document &document, const DrivenPlace &place)
{
    const Section *section = sectionAt(document, place);
    const auto index = static_cast<std::size_t>(place.index);
    if (!section || place.index < 0 || index >= section->marks.size())
        return nullptr;
    return section->marks[index]->lettering ? section->marks[index].get() : nullptr;
}

std::optional<DrivenNumber> readLettering(const Document &document, const DrivenPlace &place)
{
    const Mark *mark = letteredAt(document, place);
    const LetteringField *field = fieldNamed(kLetteringFields, place.field);
    if (!mark || !field)
        return std::nullopt;
    Lettering copy = *mark->lettering;
    return DrivenNumber{field->kind,
                        field->in ? worthOf(field->kind, field->in(copy)) : worthOf(copy.text),
                        field->label};
}

Result<Document> writeLettering(Document document, const DrivenPlace &place, const Worth &worth)
{
    const Mark *mark = letteredAt(document, place);
    const LetteringField *field = fieldNamed(kLetteringFields, place.field);
    Lettering next = *mark->lettering;
    if (field->in)
        field->in(next) = worth.number;
    else
        next.text = worth.text;
    Result<MarkPointer> written = letteredMark(next, mark->kind);
    if (!written)
        return tl::unexpected(written.error());
    return setMark(std::move(document), SectionId{place.id}, static_cast<std::size_t>(place.index),
                   *std::move(written));
}

void listLetterings(const Document &document, std::vector<DrivenPlace> &places)
{
    for (const SectionPointer &section : document.sections)
        for (std::size_t i = 0; i < section->marks.size(); ++i)
            for (const LetteringField &field : kLetteringFields)
                if (section->marks[i]->lettering)
                    places.push_back({.of = DrivenPlace::Of::Lettering,
                                      .id = section->id.value,
                                      .index = static_cast<int>(i),
                                      .field = field.key});
}

} // namespace

const DrivenOwner kDrivenSections{readSection, writeSection, listSections, nameOfSection};
const DrivenOwner kDrivenFigures{readFigure, writeFigure, listFigures, nameOfSection};
const DrivenOwner kDrivenLetterings{readLettering, writeLettering, listLetterings, nameOfSection};

} // namespace fff
