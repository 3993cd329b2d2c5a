// Copies of sections that are images of them: what is done to one is done to all (OperationResult::
// images). Internal to operations.
#pragma once

#include "core/geometry/similarity.h"
#include "core/operations/operation_context.h"

#include <map>
#include <string>
#include <vector>

namespace fff {

/// A section as part of a key: the id of a drawn one, "o" and the operation with the key below it
/// of another.
std::string keyOfSection(const SectionRef &ref);

class ImageMaker
{
public:
    /// scope: what is copied.
    ImageMaker(OperationContext &context, std::vector<SectionPointer> scope);

    const std::vector<SectionPointer> &scope() const { return m_scope; }
    /// It is not copied.
    void leave(const SectionPointer &section) { m_isCopied[section->ref()] = false; }
    bool isCopied(const SectionPointer &section) const { return m_isCopied.at(section->ref()); }

    /// An image of each section that is copied, where the placement puts it; its key is that of the
    /// section, below `above`. What is on one of them is on that one's image, what is on another
    /// section stays on that, with its slit where the placement puts it.
    void addCopies(const Similarity &placement, const std::string &above, const std::string &mark);

protected:
    OperationContext &context() { return m_context; }
    /// Another section takes its place, also in the scope.
    void change(const SectionPointer &section, const SectionPointer &next);
    /// Of the same size: nothing of it can fail.
    static Section imageOf(const Section &section, const Similarity &placement);

private:
    void moveSlit(Section &copy, const Similarity &placement);

    OperationContext &m_context;
    std::vector<SectionPointer> m_scope;
    std::map<SectionRef, bool> m_isCopied;
};

} // namespace fff
