// Which drawn section is edited when a section of the model is: itself, or the one whose image it
// is in a symmetry.
#pragma once

#include "core/model/model.h"

#include <optional>

namespace fff {

struct Origin
{
    const Section *section = nullptr; // of the document
    /// Directions in the world, from the drawn section to what stands for it. Orthogonal.
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    /// Not null: a symmetry makes it symmetric to this line, in its frame.
    const Halfplane *mirror = nullptr; // of the model
};

/// Nothing for a section that an operation made of others in its own way, and for what is not
/// there.
std::optional<Origin> originOf(const Model &model, const SectionRef &ref);

/// The contour that is edited, where the section stands: the drawn section, in the frame of what is
/// shown for it; one that is made symmetric, as it is then. Null without an origin.
SectionPointer editedSection(const Model &model, const SectionRef &ref);
/// The document with that contour: what edits of its points begin with.
Document documentToEdit(const Model &model, const SectionRef &ref);

} // namespace fff
