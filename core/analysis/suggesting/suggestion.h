// Sections for a template, suggested: planes that show its form, and that hold together, stand and
// can be assembled.
#pragma once

#include "core/base/long_work.h"
#include "core/base/message.h"
#include "core/model/model.h"

#include <cstdint>
#include <vector>

namespace fff {

inline constexpr int kMostSuggested = 100;

struct SuggestionOptions
{
    int count = 8;          // of sections that are to come, 1 … kMostSuggested
    std::uint64_t seed = 1; // another one: another suggestion
};

struct Suggestion
{
    /// With the new sections after those that were there, of its current stock. Where the template
    /// had to sink to stand, it lies lower than before.
    Document document;
    std::vector<SectionId> sections; // the new ones; maybe fewer than were wanted
    double lowered = 0.0;            // mm that the template sank into the ground, which cuts it off
    std::vector<Message> messages;   // what is not as it was wanted, a sentence each
};

/// Chooses among planes across the axes of world and form, planes of symmetry and some between
/// these, greedily, the one that shows most of what none shows yet: of the outlines from twelve
/// directions and of the surface. Each is taken only while, by the program's own analysis, plan of
/// assembly and checks, all can be slid together, all pieces are held, all stands, and nothing is
/// wrong that was not wrong before. Only where no such plane is left, those come that leave thin
/// walls beside slits.
///
/// The first two (or three, or four) sections are those that show most and stand. What would roll
/// or tip is cut off flat at the ground, as little as does and never by more than is shown all the
/// same (kNearOutline): the template then sinks by that much. What needs more has feet where its
/// sections come near to the ground under the centre of mass.
/// Sections that are in the model where the template is belong to it: new ones join these, nothing
/// is lowered, and what they show is not shown again.
///
/// With the same model and seed, n + 1 sections are n and one more.
/// Errors  UnknownReference for a template that is not there or has no mesh; BadValue, place
///         "count"; Cancelled. None where nothing comes of it: then a message says why.
/// Source  greedy choice under constraints of assembly: K. Hildebrand, B. Bickel, M. Alexa 2012,
///         crdbrd, Computer Graphics Forum 31; what tells people a form: J. McCrae, K. Singh, N.
///         Mitra 2011, Slices, ACM Transactions on Graphics 30. Ours: the measure, and that only
///         what assembly planning has proven is taken.
Result<Suggestion> suggestSections(const Model &model, TemplateId of,
                                   const SuggestionOptions &options = {},
                                   const LongWork &work = {});

} // namespace fff
