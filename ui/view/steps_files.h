// The steps of the assembly as files: one on paper, a web page, or a picture of each step. Made
// piece by piece, so that a window stays alive meanwhile.
#pragma once

#include "ui/view/steps_page.h"
#include "ui/view/steps_paper.h"

#include <memory>
#include <string>
#include <vector>

namespace fff::ui {

class StepsFiles
{
public:
    enum class Kind { Paper, Page, Pictures };
    struct Options
    {
        Kind kind = Kind::Paper;
        StepsPaper::Options paper; // and of the page
        Vec2 size{1280.0, 800.0};  // of pictures, px; at most kMaxPictureSide
        Camera looking;            // direction and projection
    };

    StepsFiles(AssemblyStepsPointer steps, const Options &options);

    /// False when there is no display or it offers no OpenGL 3.3, and something needs that: a page
    /// does without.
    bool isUsable() const;
    /// Each takes some tenths of a second.
    int pieceCount() const;
    /// In their order. False when no picture could be made.
    bool makePiece(int index);
    /// When all are made: the PDF or HTML file, or a PNG file for each step.
    std::vector<std::string> take();

private:
    Options m_options;
    StepPictures m_pictures;
    std::unique_ptr<StepsPaper> m_paper;
    std::unique_ptr<StepsPage> m_page;
    std::vector<std::string> m_files;
};

} // namespace fff::ui
