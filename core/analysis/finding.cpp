#include "core/analysis/finding.h"

#include <algorithm>

namespace fff {

const char *nameOf(Severity severity)
{
    switch (severity) {
    case Severity::Good:
        return "good";
    case Severity::Unknown:
        return "unknown";
    case Severity::Note:
        return "note";
    case Severity::Warning:
        return "warning";
    case Severity::Error:
        return "error";
    }
    return ""; // not reached: every severity is above
}

bool isSameVerdict(const Finding &a, const Finding &b)
{
    return a.kind == b.kind && a.sections == b.sections && a.others == b.others;
}

bool isAmong(const Finding &finding, std::span<const Finding> found)
{
    return std::any_of(found.begin(), found.end(),
                       [&finding](const Finding &other) { return isSameVerdict(finding, other); });
}

std::vector<SectionRef> concerned(const Finding &finding)
{
    std::vector<SectionRef> sections = finding.sections;
    for (const SectionRef &helper : finding.helpers)
        if (std::find(sections.begin(), sections.end(), helper) == sections.end())
            sections.push_back(helper);
    return sections;
}

std::optional<Severity> worst(const std::vector<Finding> &findings, Subject subject)
{
    std::optional<Severity> result;
    for (const Finding &finding : findings)
        if (finding.subject() == subject)
            result = std::max(finding.severity, result.value_or(finding.severity));
    return result;
}

Message titleOf(const Finding &finding)
{
    const FindingKind &kind = *finding.kind;
    if (finding.isYet)
        return {kind.yet, {}};
    return kind.titled ? kind.titled(finding) : Message{kind.title, {}};
}

Text adviceOf(const Finding &finding)
{
    return finding.kind->advised ? finding.kind->advised(finding) : finding.kind->advice;
}

NamedSections namesOf(const Model &model, const std::vector<SectionRef> &sections)
{
    NamedSections named;
    for (const SectionRef &section : sections)
        named.names.push_back(model.nameOf(section));
    return named;
}

Named nameOf(const Model &model, const SectionRef &section)
{
    return {model.nameOf(section)};
}

Named nameAt(const Finding &finding, const Model &model, std::size_t index)
{
    return index < finding.sections.size() ? nameOf(model, finding.sections[index]) : Named{};
}

Message joined(Message first, Message second)
{
    if (second.isEmpty())
        return first;
    return {kOneAfterOther, {std::move(first), std::move(second)}};
}

} // namespace fff
