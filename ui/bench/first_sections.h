// What is wrong with a model of which only the first sections are there is not said in red while
// they are drawn: the next one may mend it.
#pragma once

#include <QObject> // first: moc stumbles over some standard headers
#include <QTimer>

#include <functional>

namespace fff {

class CheckList;
class Session;
struct Model;

namespace ui {

class FirstSections : public QObject
{
    Q_OBJECT
public:
    /// ms that a model is left alone until it is taken as it is
    static constexpr int kPause = 3000;

    /// Both outlive it.
    /// isDrawing  whether something is in the hand: then nobody has left the model alone
    FirstSections(const Session &session, CheckList &list, std::function<bool()> isDrawing,
                  QObject *parent = nullptr);

    /// Now: it is to be cut.
    void takeAsIs();
    /// For kPause, which begins anew while something is in the hand.
    void leaveAlone();

private:
    void follow(const Model &before, const Model &after);

    const Session &m_session;
    CheckList &m_list;
    std::function<bool()> m_isDrawing;
    QTimer m_pause;
};

} // namespace ui
} // namespace fff
