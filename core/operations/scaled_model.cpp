#include "core/operations/scaled_model.h"

#include "core/base/tolerances.h"
#include "core/model/transformed.h"
#include "core/operations/operation_kind.h"

#include <cmath>
#include <map>

namespace fff {

namespace {

class Scaler
{
public:
    explicit Scaler(double factor) : m_factor(factor) {}

    Result<SectionPointer> section(const Section &before)
    {
        const Similarity size{.scale = m_factor};
        // Sections of one shape keep having one.
        const ShapeMap shared = [this](const ShapePointer &shape, const PlaneMap &map) {
            const auto known = m_shapes.find(shape);
            if (known != m_shapes.end())
                return Result<ShapePointer>(known->second);
            Result<ShapePointer> next = mappedShape(shape, map);
            if (next)
                m_shapes.emplace(shape, *next);
            return next;
        };
        Result<Section> next = transformed(before, size, shared);
        if (!next)
            return tl::unexpected(next.error());
        if (next->parent)
            next->parent = transformed(*next->parent, size);
        const Box3 box = worldBounds(*next->shape, next->frame);
        if (!(box.min.cwiseAbs().cwiseMax(box.max.cwiseAbs()).maxCoeff() <= kMaxCoordinate))
            return failure(ErrorCode::NonFinite, before.name);
        return std::make_shared<const Section>(*std::move(next));
    }

    Result<OperationPointer> operation(const OperationPointer &before) const
    {
        const OperationKind *kind = operationKind(before->kind);
        Operation next = *before;
        for (auto &[key, value] : next.parameters) {
            const ParameterSpec *spec = kind ? kind->parameter(key) : nullptr;
            double *number = std::get_if<double>(&value);
            if (!spec || !number || spec->unit != ParameterSpec::Unit::Length)
                continue;
            *number *= m_factor;
            if (counts(*spec, next) && !isAllowed(*spec, value))
                return failure(ErrorCode::BadValue, before->name,
                               {std::to_string(*number) + " mm", rangeText(*spec)});
        }
        return std::make_shared<const Operation>(std::move(next));
    }

private:
    double m_factor;
    std::map<ShapePointer, ShapePointer> m_shapes; // by that before
};

} // namespace

Result<Document> scaledModel(Document document, double factor)
{
    if (!(std::isfinite(factor) && factor > 0.0))
        return failure(ErrorCode::BadValue, "factor", {std::to_string(factor), "a factor above 0"});
    if (factor == 1.0)
        return document;
    Scaler scaler(factor);
    for (SectionPointer &section : document.sections) {
        Result<SectionPointer> next = scaler.section(*section);
        if (!next)
            return tl::unexpected(next.error());
        section = *std::move(next);
    }
    for (OperationPointer &operation : document.operations) {
        Result<OperationPointer> next = scaler.operation(operation);
        if (!next)
            return tl::unexpected(next.error());
        operation = *std::move(next);
    }
    mapPlaces(
        document, [](const SectionRef &) { return true; }, PlaneMap::scaled(factor));
    for (Dimension &dimension : document.dimensions)
        for (Anchor *anchor : {&dimension.from, &dimension.to}) {
            if (anchor->section == SectionRef())
                anchor->at *= factor;
            else
                anchor->at.z() *= factor; // so that lengths are as many times as long
        }
    for (TemplatePointer &pointer : document.templates) {
        Template next = *pointer;
        if (next.on == SectionRef()) {
            next.frame.origin *= factor;
            next.scale *= factor;
        }
        for (Magnet &magnet : next.magnets)
            magnet.radius *= factor;
        if (next != *pointer)
            pointer = std::make_shared<const Template>(std::move(next));
    }
    return document;
}

} // namespace fff
