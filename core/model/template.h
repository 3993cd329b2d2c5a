// What sections are drawn after: meshes, pictures and drawings. They lie beside the model and are
// no part of it: nothing of them is cut, weighed or checked.
#pragma once

#include "core/base/ids.h"
#include "core/geometry/similarity.h"
#include "core/model/section.h"

#include <memory>
#include <string>
#include <vector>

namespace fff {

/// A mesh lets its form shine through sections; a picture does so.
inline constexpr double kMeshOpacity = 0.25, kPictureOpacity = 0.6;
/// How near to its plane a section pulls a mesh, mm.
inline constexpr double kMagnetRadius = 12.7, kLeastMagnet = 0.1, kMostMagnet = 1000.0;
/// mm a unit of the file.
inline constexpr double kLeastTemplateScale = 1e-9, kMostTemplateScale = 1e9;

enum class TemplateKind {
    Mesh,    // triangles
    Picture, // pixels, whose unit is one pixel
    Curves,  // lines of a drawing, in mm
};

/// A section into whose plane the mesh is pulled, as far as it is near.
struct Magnet
{
    SectionRef section;
    double radius = kMagnetRadius; // mm

    bool operator==(const Magnet &) const = default;
};

/// What the bytes are: core/templates/template_mesh.h, template_picture.h and template_curves.h.
struct TemplateMesh;
struct TemplatePicture;
struct TemplateCurves;
using TemplateMeshPointer = std::shared_ptr<const TemplateMesh>;
using TemplatePicturePointer = std::shared_ptr<const TemplatePicture>;
using TemplateCurvesPointer = std::shared_ptr<const TemplateCurves>;

struct Template
{
    TemplateId id;
    TemplateKind kind = TemplateKind::Mesh;
    std::string name;
    std::string blob; // the SHA-256 of its bytes, which are in the document; empty: by reference
    std::string file; // where it came from, for people; by reference its absolute path
    /// Where the middle of it lies, and the axes of the file: of a mesh in the world; of what is
    /// flat x runs to the right in it and y up, in the coordinates of the section that it lies on
    /// (x, y, and along its normal), or in the world.
    Frame frame;
    SectionRef on = {};            // of what is flat; empty: in the world
    double scale = 1.0;            // mm a unit of the file
    bool isFlipped = false;        // x runs the other way in it: seen from behind
    double opacity = kMeshOpacity; // 0 … 1
    bool isHidden = false, isLocked = false;
    std::vector<Magnet> magnets = {}; // of a mesh; ascending by section, each once
    /// That of its kind is read from its bytes; null where these are missing or make no sense. It
    /// follows from them, so it is neither compared nor saved.
    TemplateMeshPointer mesh = {};
    TemplatePicturePointer picture = {};
    TemplateCurvesPointer curves = {};

    /// What is cut of it is the same: all but how it is shown and called.
    bool hasFormOf(const Template &other) const
    {
        return hasContentOf(other) && frame == other.frame && on == other.on &&
               scale == other.scale && isFlipped == other.isFlipped && magnets == other.magnets;
    }
    bool hasContentOf(const Template &other) const
    {
        return mesh == other.mesh && picture == other.picture && curves == other.curves;
    }
    /// Its bytes were read.
    bool isRead() const { return mesh || picture || curves; }
    bool isFlat() const { return kind != TemplateKind::Mesh; }
    /// From the file's coordinates, about the middle of what is in it, to those of `frame`'s space.
    Similarity placement() const;
    bool operator==(const Template &other) const;
};

/// Puts them into their order; of one section the first counts.
void settleMagnets(Template &one);

using TemplatePointer = std::shared_ptr<const Template>;

} // namespace fff
