// The steps of the assembly as files: one on paper, or a picture of each step. Made piece by piece,
// so that a window stays alive meanwhile.
#pragma once

#include "ui/view/steps_paper.h"

#include <memory>
#include <string>
#include <vector>

namespace fff::ui {

class StepsFiles
{
public:
    enum class Kind { Paper, Pictures };
    struct Options
    {
        Kind kind = Kind::Paper;
        StepsPaper::Options paper;
        Vec2 size{1280.0, 800.0}; // of pictures, px; at most kMaxPictureSide
        Camera looking;           // direction and projection
    };

    StepsFiles(AssemblyStepsPointer steps, const Options &options);

    /// False when there is no display or it offers no OpenGL 3.3.
    bool isUsable() const { return m_pictures.isUsable(); }
    /// Each takes some tenths of a second.
    int pieceCount() const;
    /// In their order. False when no picture could be made.
    bool makePiece(int index);
    /// When all are made: the PDF file, or a PNG file for each step.
    std::vector<std::string> take();

private:
    Options m_options;
    StepPictures m_pictures;
    std::unique_ptr<StepsPaper> m_paper;
    std::vector<std::string> m_files;
};

} // namespace fff::ui
