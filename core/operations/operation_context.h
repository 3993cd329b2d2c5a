// What an operation sees while it works, and where it puts what it makes. All that it looks at is
// noted: while that stays the same, its result does.
#pragma once

#include "core/operations/section_lookup.h"

#include <optional>
#include <set>
#include <string_view>

namespace fff {

struct OperationKind;

class OperationContext
{
public:
    /// above: what comes before the operation. previous: what it came to before, or null. All
    /// outlive the context.
    OperationContext(const Document &document, const OperationKind &kind,
                     const OperationPointer &operation, const SectionLookup &above,
                     const OperationResult *previous);

    const Operation &operation() const { return *m_result.operation; }

    // ---- what it reads ----
    /// Null when there is none, which is noted as missing.
    SectionPointer input(std::string_view role);
    /// All that there are; one that is gone is noted as missing, and the list is empty then.
    std::vector<SectionPointer> inputs(std::string_view role);
    /// Null when it is not there.
    SectionPointer find(const SectionRef &ref);
    const Stock &stock(StockId id);
    /// The template that the operation is of, its name and its form; null when it is not there.
    TemplatePointer subject();
    /// What sections of that are made of.
    StockId stockOfNew();
    /// All sections above. Looking at them ties the result to each of them.
    const std::vector<SectionPointer> &all();

    /// The parameter's value. It has to be one of the kind's, of that type.
    bool isOn(std::string_view key) const;
    double number(std::string_view key) const;
    int count(std::string_view key) const;
    std::string choice(std::string_view key) const;
    /// Nothing when it follows from the inputs.
    std::optional<double> freeNumber(std::string_view key) const;

    // ---- what it makes ----
    /// Adds a section; its key names it among those of this operation. What it was made of before
    /// is used again where it is the same.
    void add(std::string key, Section section);
    bool isHidden(const std::string &key) const;
    /// A shape of these curves: the one that the instance had before if it is the same.
    Result<ShapePointer> shape(const std::string &key, Contour contour, std::vector<Contour> holes);
    /// The same of a shape that was made elsewhere.
    ShapePointer kept(const std::string &key, ShapePointer shape);
    /// The same of a shape that several instances share.
    ShapePointer keptOfAny(ShapePointer shape);
    /// What was added as `key` is the image of this section.
    void setImage(const std::string &key, const SectionRef &of, bool isMirrored);
    /// The section is symmetric to this line, in its frame.
    void setMirror(const SectionRef &ref, const Halfplane &line);
    /// Makes another section of one from above; null: takes it away.
    void change(const SectionRef &ref, SectionPointer section);
    void notice(OperationNotice notice);
    /// What could be made; else nothing. Where it is not that it would be too small or too large,
    /// it is noted that the operation failed.
    template <class T>
    std::optional<T> made(Result<T> result)
    {
        if (result)
            return *std::move(result);
        noticeFailure(result.error());
        return std::nullopt;
    }
    /// A free parameter's value.
    void found(std::string_view key, double value);
    /// Where handles of parameters go: points in the world and the values there, ascending.
    void setTrack(std::vector<std::pair<Vec3, double>> track);

    OperationResult take();

private:
    void noticeFailure(const Error &error);
    ParameterValue value(std::string_view key) const;
    SectionPointer previous(const std::string &key) const;

    const Document &m_document;
    const OperationKind &m_kind;
    const SectionLookup &m_above;
    const OperationResult *m_previous;
    OperationResult m_result;
    std::set<SectionRef> m_read;
    std::set<ShapePointer> m_shapesBefore; // once asked for
};

} // namespace fff
