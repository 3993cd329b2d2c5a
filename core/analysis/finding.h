// What the analysis finds out about a model that a person wants to know before cutting it: does it
// hold together, does it stand, does it fit the sheet, can it be put together.
//
// A kind of finding has a file of its own in core/analysis/findings: what finds it, its details,
// its sentence, what can be done about it and what the view shows of it. To add one: that file, and
// the line of its finder (checks.cpp, plan_checks.cpp), or a stage with findings of its own.
#pragma once

#include "core/analysis/problem_look.h"
#include "core/base/message.h"
#include "core/model/joint_ref.h"
#include "core/model/model.h"

#include <memory>
#include <optional>
#include <span>
#include <typeinfo>
#include <utility>
#include <vector>

namespace fff {

struct Analysis;
struct Finding;
struct FindingAction;
struct ActionKind;

/// A badge speaks about a subject; its severity is the worst of that subject's findings.
enum class Subject { Connection, Stability, Assembly, Strength, Size, Mass, Joints };

enum class Severity { Good, Unknown, Note, Warning, Error }; // ordered
/// Published: "good", "unknown", "note", "warning", "error".
const char *nameOf(Severity severity);

struct FindingKind
{
    const char *name; // published, as in `check --json`; two kinds may share one
    Subject subject;
    Text title; // a verdict in a few words, for a badge: "Stands", "Falls over"
    /// Why, in whole sentences: "Falls over forwards. The centre of mass lies 45.4 mm in front of
    /// the feet." The model is the one that was looked at: it has the sections' names.
    Message (*sentence)(const Finding &, const Model &);
    /// What may be done about it at once, the mildest first; edits among them may turn out not to
    /// be possible. Null: nothing.
    std::vector<FindingAction> (*actions)(const Finding &, const Analysis &) = nullptr;
    /// What the view shows of it besides red sections and a number. Null: nothing.
    ProblemLook (*look)(const Finding &) = nullptr;
    /// What is offered where there are so many that they are one row. Null: nothing.
    const ActionKind *forAll = nullptr;
    /// How many problems it is, for whoever compares two models. Null: one.
    int (*weight)(const Finding &) = nullptr;
    /// What a person can do about it where nothing is offered; may be empty.
    Text advice = {};
    /// Its title where that has something of the finding in it: "Holds 350 g". Null: `title` is it.
    Message (*titled)(const Finding &) = nullptr;
    /// How far it is from what is graver, in a unit of its own; the more, the better. Null: there
    /// is no measure.
    double (*spare)(const Finding &) = nullptr;
    /// Even as a note it says that something is lost: no mend may bring it.
    bool isLoss = false;
    /// As long as it is wrong nothing else of its subject is known: what is wrong then was so all
    /// along, and a mend that brings it to light helps.
    bool hidesOthers = false;
    /// Its title while the first sections of a model are drawn, which may still mend it: "Not
    /// connected yet". Empty: it is wrong at once.
    Text yet = {};
    /// What a person can do about it, by the finding. Null: `advice` is it.
    Text (*advised)(const Finding &) = nullptr;
};

/// A value. What only its kind knows of is in its details, which copies share.
struct Finding
{
    const FindingKind *kind = nullptr;
    Severity severity = Severity::Good;
    bool isYet = false;               // nothing is wrong so far (FindingKind::yet)
    std::vector<SectionRef> sections; // whom it is about; empty: the whole model
    std::vector<SectionRef> others;   // whom its sentence names besides
    std::vector<SectionRef> helpers;  // who would have to change for it to be mended
    std::optional<Vec3> at;           // where to look, world, mm
    std::optional<JointRef> joint;    // that it is about, where it is about one

    bool is(const FindingKind &other) const { return kind == &other; }
    Subject subject() const { return kind->subject; }

    /// Null where they are of another type.
    template <class Details>
    const Details *details() const
    {
        return m_type && *m_type == typeid(Details) ? static_cast<const Details *>(m_details.get())
                                                    : nullptr;
    }
    template <class Details>
    void setDetails(Details details)
    {
        m_details = std::make_shared<const Details>(std::move(details));
        m_type = &typeid(Details);
    }

private:
    std::shared_ptr<const void> m_details;
    const std::type_info *m_type = nullptr;
};

inline Finding makeFinding(const FindingKind &kind, Severity severity)
{
    Finding finding;
    finding.kind = &kind;
    finding.severity = severity;
    return finding;
}
template <class Details>
Finding makeFinding(const FindingKind &kind, Severity severity, Details details)
{
    Finding finding = makeFinding(kind, severity);
    finding.setDetails(std::move(details));
    return finding;
}

/// Whether it is the same verdict after a change of the model; its numbers may differ.
bool isSameVerdict(const Finding &a, const Finding &b);
/// Whether one of them is the same verdict.
bool isAmong(const Finding &finding, std::span<const Finding> found);
/// Whom it is about, and who would have to change.
std::vector<SectionRef> concerned(const Finding &finding);
/// The worst of a subject, nothing when it has none.
std::optional<Severity> worst(const std::vector<Finding> &findings, Subject subject);

// For sentences.

Message titleOf(const Finding &finding);
/// What a person can do about it; may be empty.
Text adviceOf(const Finding &finding);
NamedSections namesOf(const Model &model, const std::vector<SectionRef> &sections);
Named nameOf(const Model &model, const SectionRef &section);
/// Of one of its sections, by its place; empty where it has none there.
Named nameAt(const Finding &finding, const Model &model, std::size_t index);
/// One sentence after the other.
Message joined(Message first, Message second);

} // namespace fff
