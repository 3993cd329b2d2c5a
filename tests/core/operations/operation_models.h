// Models for the tests of operations.
#pragma once

#include "core/model/edits.h"
#include "core/model/operation_edits.h"
#include "core/operations/evaluate.h"
#include "core/operations/operation_kind.h"
#include "tests/core/shapes.h"

namespace fff::test {

/// Upright in the XY plane unless said otherwise.
inline Frame frontFrame(const Vec3 &origin = Vec3::Zero())
{
    return {origin, Vec3::UnitX(), Vec3::UnitY()};
}
/// Upright, facing along −X: its x is the world's Z.
inline Frame sideFrame(const Vec3 &origin)
{
    return {origin, Vec3::UnitZ(), Vec3::UnitY()};
}

inline ShapePointer shapeOf(const Contour &contour, const std::vector<Contour> &holes = {})
{
    return Shape::make(contour, holes).value();
}

inline SectionId add(Document &document, const char *name, ShapePointer shape, const Frame &frame,
                     std::optional<Parent> parent = {})
{
    document =
        addSection(std::move(document), {name, std::move(parent), std::move(shape), frame, {}})
            .value();
    return document.sections.back()->id;
}

/// A spine from x = 0 to 200 whose lower edge, and thickness, wave; y from about 60 to 100.
inline Contour spine()
{
    return Contour::fromPoints({{0, 80},
                                {30, 40},
                                {70, 50},
                                {100, 60},
                                {130, 70},
                                {170, 75},
                                {200, 82},
                                {200, 86},
                                {150, 110},
                                {100, 105},
                                {60, 102},
                                {0, 100}})
        .value();
}

inline Operation operation(const char *kind, std::map<std::string, std::vector<SectionRef>> inputs,
                           std::map<std::string, ParameterValue> values = {})
{
    Operation result = newOperation(*operationKind(kind));
    result.name = kind;
    for (auto &[role, refs] : inputs)
        for (const SectionRef &ref : refs)
            result.inputs[role].push_back({ref, {}});
    for (auto &[key, value] : values)
        result.parameters.insert_or_assign(key, value);
    return result;
}

inline OperationId add(Document &document, Operation operation)
{
    document = addOperation(std::move(document), std::move(operation));
    return document.operations.back()->id;
}

/// A spine and a rib across it at x = 60 that hangs out of it downwards, from y = 84.
struct FishBones
{
    Document document = newDocument();
    SectionId spine = add(document, "Spine", shapeOf(test::spine()), frontFrame());
    SectionId rib =
        add(document, "Rib",
            shapeOf(Contour::fromPoints({{-20, 20},
                                         {-22, 50},
                                         {-12, 82},
                                         {0, 84},
                                         {12, 82},
                                         {22, 50},
                                         {20, 20},
                                         {8, 10},
                                         {-8, 10}})
                        .value()),
            sideFrame({60, 0, 0}), Parent{SectionRef(SectionId{2}), {60, 84}, {60, 55}});
};

} // namespace fff::test
