#include "tests/tools/samples/maker.h"

#include "core/assembly/crossing.h"
#include "core/base/units.h"
#include "core/io/document_file.h"
#include "core/model/bindings.h"
#include "core/model/edits.h"
#include "core/model/figures.h"
#include "core/model/lettering.h"
#include "core/model/load_edits.h"
#include "core/model/marks.h"
#include "core/model/operation_edits.h"
#include "core/operations/driven.h"
#include "core/operations/evaluate.h"
#include "core/operations/operation_kind.h"
#include "core/values/presets.h"
#include "core/values/value_edits.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace fff::samples {

namespace {

[[noreturn]] void fail(const std::string &what)
{
    std::fprintf(stderr, "%s could not be made\n", what.c_str());
    std::exit(1);
}

template <class T, class E>
T taken(tl::expected<T, E> result, const std::string &what)
{
    if (!result)
        fail(what);
    return *std::move(result);
}

/// From inside to where the section leaves its parent: that end at which it reaches further out.
Parent parentOf(const Section &parent, const Section &section)
{
    const Crossing crossing =
        findCrossing(*parent.shape, parent.frame, *section.shape, section.frame);
    if (crossing.overlaps.empty())
        fail(section.name);
    const Overlap &overlap = *std::max_element(
        crossing.overlaps.begin(), crossing.overlaps.end(),
        [](const Overlap &a, const Overlap &b) { return a.to - a.from < b.to - b.from; });
    const bool isHigh = overlap.b.to.at - overlap.a.to.at > overlap.a.from.at - overlap.b.from.at;
    const auto at = [&](double s) { return parent.frame.toLocal(crossing.axis.at(s)); };
    return {parent.ref(), at(isHigh ? overlap.from : overlap.to),
            at(isHigh ? overlap.to : overlap.from)};
}

} // namespace

Maker::Maker(double thickness) : m_document(newDocument())
{
    Stock stock = *m_document.stocks.front();
    stock.thickness = thickness;
    m_document = taken(setStock(m_document, stock), "the stock");
}

Maker::Maker(Stock stock) : m_document(newDocument())
{
    stock.id = m_document.stocks.front()->id;
    m_document = taken(setStock(m_document, std::move(stock)), "the stock");
}

SectionRef Maker::add(const std::string &name, const Frame &frame, Contour contour,
                      std::vector<Contour> holes)
{
    NewSection section;
    section.name = name;
    section.frame = frame;
    section.shape = taken(Shape::make(std::move(contour), std::move(holes)), name);
    m_document = taken(addSection(std::move(m_document), std::move(section)), name);
    return m_document.sections.back()->id;
}

SectionRef Maker::addOn(const SectionRef &parent, const std::string &name, const Frame &frame,
                        Contour contour, std::vector<Contour> holes)
{
    NewSection section;
    section.name = name;
    section.frame = frame;
    section.shape = taken(Shape::make(std::move(contour), std::move(holes)), name);
    Section placed;
    placed.name = name;
    placed.frame = frame;
    placed.shape = section.shape;
    const Model model = evaluate(m_document);
    const Section *on = model.find(parent);
    if (!on)
        fail(name);
    section.parent = parentOf(*on, placed);
    m_document = taken(addSection(std::move(m_document), std::move(section)), name);
    return m_document.sections.back()->id;
}

OperationId Maker::apply(const std::string &kind, const std::string &name, const Inputs &inputs,
                         const Values &values)
{
    const OperationKind *known = operationKind(kind);
    if (!known)
        fail(name);
    Operation operation = newOperation(*known);
    operation.name = name;
    const Model before = evaluate(m_document);
    for (const auto &[role, refs] : inputs) {
        for (const SectionRef &ref : refs) {
            if (!known->input(role) || !before.find(ref))
                fail(name);
            operation.inputs[role].push_back({ref, before.nameOf(ref)});
        }
    }
    for (const auto &[key, value] : values) {
        const ParameterSpec *spec = known->parameter(key);
        if (!spec || !isAllowed(*spec, value))
            fail(name + ": " + key);
        operation.parameters.insert_or_assign(key, value);
    }
    m_document = addOperation(std::move(m_document), std::move(operation));
    const OperationId id = m_document.operations.back()->id;
    const Model model = evaluate(m_document);
    if (const OperationResult *result = model.resultOf(id); !result || !result->notices.empty())
        fail(name);
    return id;
}

void Maker::hide(OperationId operation, const std::string &key)
{
    Exception exception;
    exception.state = Exception::State::Hidden;
    m_document = taken(setException(m_document, {operation, key}, exception), key);
}

void Maker::open(const SectionRef &a, const SectionRef &b, const Vec2 &way)
{
    JointOverride joint;
    joint.a = a;
    joint.b = b;
    joint.opens = way;
    m_document = taken(setJointOverride(std::move(m_document), std::move(joint)), "a joint");
}

void Maker::hang(const SectionRef &section, const Vec2 &position, double kilograms)
{
    Load weight;
    weight.mass = kilograms;
    put(section, position, std::move(weight));
}

void Maker::put(const SectionRef &section, const Vec2 &position, Load weight)
{
    weight.section = section;
    weight.position = position;
    m_document = taken(addLoad(std::move(m_document), weight), "a weight");
}

SectionRef Maker::addFigures(const std::string &name, const Frame &frame, const Figure &contour,
                             const std::vector<Figure> &holes)
{
    std::vector<Contour> made;
    for (const Figure &hole : holes)
        made.push_back(taken(contourOf(hole), name));
    const SectionRef section = add(name, frame, taken(contourOf(contour), name), std::move(made));
    m_document = taken(addFigure(std::move(m_document), section.drawn, contour), name);
    for (const Figure &hole : holes)
        m_document = taken(addFigure(std::move(m_document), section.drawn, hole), name);
    return section;
}

void Maker::write(const SectionRef &section, const Lettering &words)
{
    MarkPointer mark = taken(letteredMark(words, Mark::Kind::Engraved), words.text);
    m_document = taken(addMark(std::move(m_document), section.drawn, std::move(mark)), words.text);
}

void Maker::show(const Adjustable &value)
{
    Value shown;
    shown.name = value.name;
    shown.kind = value.kind;
    shown.typed = value.typed;
    shown.note = value.note;
    shown.isShown = true;
    if (value.kind != ValueKind::Text) {
        const double unit = value.kind == ValueKind::Angle ? radians(1.0) : 1.0;
        shown.range = {unit * value.least, unit * value.most, unit * value.step};
    }
    m_document = taken(addValue(std::move(m_document), std::move(shown)), value.name);
}

void Maker::preset(const std::string &name, const std::map<std::string, std::string> &typed)
{
    fff::Values set = m_document.values;
    for (const auto &[value, text] : typed)
        set = taken(typedValue(set, set.find(std::string_view(value))->id, text, {}), name);
    m_document.values = withPreset(m_document.values, takenPreset(set, name));
}

void Maker::derive(const std::string &name, ValueKind kind, const std::string &typed,
                   const std::string &note)
{
    Value value;
    value.name = name;
    value.kind = kind;
    value.typed = typed;
    value.note = note;
    m_document = taken(addValue(std::move(m_document), std::move(value)), name);
}

void Maker::drive(const SectionRef &section, const std::string &field, const std::string &typed)
{
    driveAt("section/" + std::to_string(section.drawn.value) + '/' + field, typed);
}

void Maker::drive(OperationId operation, const std::string &key, const std::string &typed)
{
    driveAt("operation/" + std::to_string(operation.value) + '/' + key, typed);
}

void Maker::driveFigure(const SectionRef &section, int boundary, const std::string &number,
                        const std::string &typed)
{
    driveAt("figure/" + std::to_string(section.drawn.value) + '/' + std::to_string(boundary) + '/' +
                number,
            typed);
}

void Maker::driveWords(const SectionRef &section, int mark, const std::string &field,
                       const std::string &typed)
{
    driveAt("lettering/" + std::to_string(section.drawn.value) + '/' + std::to_string(mark) + '/' +
                field,
            typed);
}

void Maker::driveLoad(const std::string &field, const std::string &typed)
{
    driveAt("load/" + std::to_string(m_document.loads.back().id.value) + '/' + field, typed);
}

void Maker::driveAt(const std::string &key, const std::string &typed)
{
    const std::optional<DrivenPlace> place = placeOfKey(m_document, key);
    if (!place)
        fail(key);
    m_document = taken(bound(std::move(m_document), *place, typed), key + " = " + typed);
}

Vec3 Maker::middleOf(const SectionRef &section) const
{
    const Section &drawn = *m_document.find(section.drawn);
    return drawn.frame.toWorld(drawn.shape->bounds().center());
}

std::vector<SectionPointer> Maker::sections() const
{
    return evaluate(m_document).sections();
}

void Maker::write(const std::string &folder, const std::string &name) const
{
    const QString path = QString::fromStdString(folder + "/" + name + ".fff");
    if (!io::writeDocument(path, m_document))
        fail(name);
    // A contour that crosses itself would be mended each time that the file is opened.
    if (const auto loaded = io::readDocument(path); !loaded || !loaded->warnings.empty())
        fail("a sound " + name);
}

std::string millimetres(double length)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.6g mm", std::round(1000.0 * length) / 1000.0);
    return text;
}

Frame facingFront(double z)
{
    return {{0.0, 0.0, z}, Vec3::UnitX(), Vec3::UnitY()};
}

Frame facingRight(double x)
{
    return {{x, 0.0, 0.0}, -Vec3::UnitZ(), Vec3::UnitY()};
}

Frame lying(double y)
{
    return {{0.0, y, 0.0}, Vec3::UnitX(), -Vec3::UnitZ()};
}

Frame radial(double angle)
{
    return {Vec3::Zero(), {std::cos(angle), 0.0, std::sin(angle)}, Vec3::UnitY()};
}

} // namespace fff::samples
