#include "core/operations/scaled_model.h"

#include "core/base/tolerances.h"
#include "core/model/mapped_shape.h"
#include "core/operations/operation_kind.h"

#include <cmath>
#include <map>

namespace fff {

namespace {

class Scaler
{
public:
    explicit Scaler(double factor)
        : m_factor(factor), m_matrix(factor * Eigen::Matrix2d::Identity())
    {
    }

    Result<SectionPointer> section(const Section &before)
    {
        Section next = before;
        next.frame.origin *= m_factor;
        if (next.parent) {
            next.parent->slitFrom *= m_factor;
            next.parent->slitTo *= m_factor;
        }
        auto known = m_shapes.find(before.shape.get());
        if (known == m_shapes.end()) {
            const Result<ShapePointer> shape = mapped(before.shape, m_matrix, Vec2::Zero());
            if (!shape)
                return failure(shape.error().code, before.name);
            known = m_shapes.emplace(before.shape.get(), *shape).first;
        }
        next.shape = known->second;
        next.figures.clear();
        for (const Figure &figure : before.figures)
            if (std::optional<Figure> scaled = mapped(figure, m_matrix, Vec2::Zero()))
                next.figures.push_back(*std::move(scaled));
        next.marks = mapped(before.marks, m_matrix, Vec2::Zero());
        const Box3 box = worldBounds(*next.shape, next.frame);
        if (!(box.min.cwiseAbs().cwiseMax(box.max.cwiseAbs()).maxCoeff() <= kMaxCoordinate))
            return failure(ErrorCode::NonFinite, before.name);
        return std::make_shared<const Section>(std::move(next));
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

    JointOverridePointer joint(const JointOverridePointer &before) const
    {
        if (before->shares.empty())
            return before;
        JointOverride next = *before;
        for (JointOverride::Share &share : next.shares)
            share.at *= m_factor;
        return std::make_shared<const JointOverride>(std::move(next));
    }

private:
    double m_factor;
    Eigen::Matrix2d m_matrix;
    std::map<const Shape *, ShapePointer> m_shapes;
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
    for (JointOverridePointer &joint : document.jointOverrides)
        joint = scaler.joint(joint);
    for (Weight &weight : document.weights)
        weight.position *= factor;
    for (Dimension &dimension : document.dimensions) {
        dimension.from.at *= factor;
        dimension.to.at *= factor;
    }
    return document;
}

} // namespace fff
