// The model where it moves, larger than it does: as far as a slider says, or to and fro.
#pragma once

#include <QWidget> // first: moc stumbles over some standard headers

#include <QTimer>

class QLabel;
class QSlider;
class QToolButton;

namespace fff::ui {

class PropertyGroup;
class Workbench;

class MovementRows : public QObject
{
    Q_OBJECT
public:
    /// Adds its rows to the group, which it belongs to.
    MovementRows(Workbench &bench, PropertyGroup *group);

    /// What is known may have changed.
    void refresh();
    /// Nobody sees it: the model stands where it stands.
    void stop();

private:
    void play(bool on);
    void advance();

    Workbench &m_bench;
    QSlider *m_slider = nullptr;
    QToolButton *m_play = nullptr;
    QLabel *m_words = nullptr;
    QTimer m_frames;      // while it goes to and fro
    double m_began = 0.0; // ms
};

} // namespace fff::ui
