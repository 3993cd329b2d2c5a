#include "ui/view/steps_files.h"

#include <QBuffer>

#include <utility>

namespace fff::ui {

StepsFiles::StepsFiles(AssemblyStepsPointer steps, const Options &options)
    : m_options(options), m_pictures(std::move(steps), options.looking)
{
    if (options.kind == Kind::Paper)
        m_paper = std::make_unique<StepsPaper>(m_pictures, options.paper);
    if (options.kind == Kind::Page)
        m_page = std::make_unique<StepsPage>(m_pictures, options.paper, options.looking);
}

bool StepsFiles::isUsable() const
{
    return m_page ? m_page->isUsable() : m_pictures.isUsable();
}

int StepsFiles::pieceCount() const
{
    return m_paper ? m_paper->pieceCount() : m_pictures.steps().playback.stepCount();
}

bool StepsFiles::makePiece(int index)
{
    if (m_paper)
        return m_paper->makePiece(index);
    if (m_page)
        return m_page->makePiece(index);
    const QImage image = m_pictures.step(index, StepPictures::Fit::AllSteps, m_options.size, 1.0);
    QBuffer png;
    png.open(QIODevice::WriteOnly);
    if (image.isNull() || !image.save(&png, "PNG"))
        return false;
    m_files.push_back(png.data().toStdString());
    return true;
}

std::vector<std::string> StepsFiles::take()
{
    if (m_paper)
        m_files = {m_paper->take().toStdString()};
    if (m_page)
        m_files = {m_page->take().toStdString()};
    return std::exchange(m_files, {});
}

} // namespace fff::ui
