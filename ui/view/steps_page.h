// The steps as one web page that needs nothing but itself, for a phone: the model that a finger
// turns, a slider through the steps, and the list of parts. Where a browser has no WebGL it shows
// pictures of the steps; so it does where the program was built without three.js.
#pragma once

#include "ui/view/steps_paper.h"

#include <QByteArray>

#include <vector>

namespace fff::ui {

class StepsPage
{
public:
    /// Of which the size of the paper is of no account.
    using Options = StepsPaper::Options;

    /// The pictures outlive it. To be used on their thread.
    /// looking  from where the model is seen at first
    StepsPage(StepPictures &pictures, const Options &options, const Camera &looking);

    /// Whether three.js was there when the program was built.
    static bool hasModel();
    /// False when neither the model nor pictures can be shown.
    bool isUsable() const { return hasModel() || m_pictures.isUsable(); }

    /// A picture for each step.
    int pieceCount() const { return m_steps.playback.stepCount(); }
    /// In their order. On a display that makes no pictures the page goes without, and says so;
    /// false only when one could not be made although others can.
    bool makePiece(int index);
    /// The page, when all is made: HTML, UTF-8. Same bytes for same input on one machine.
    QByteArray take();

private:
    QString picturesPart() const;
    QString tablePart() const;

    StepPictures &m_pictures;
    const AssemblySteps &m_steps;
    Options m_options;
    Camera m_looking;
    std::vector<QByteArray>
        m_images; // as addresses that hold their own bytes; of each step, or none
};

} // namespace fff::ui
