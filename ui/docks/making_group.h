// What is made of a template at once: sections that are suggested, and flat sheets.
#pragma once

#include <QWidget> // first: moc stumbles over some standard headers

class QPushButton;

namespace fff::ui {

class MakingGroup : public QWidget
{
    Q_OBJECT
public:
    explicit MakingGroup(QWidget *parent = nullptr);

    /// hasSections  in the model: another one can join them
    /// hasLast      what was suggested last is the newest step: there can be another instead
    void refresh(bool hasSections, bool hasLast);

Q_SIGNALS:
    void suggestionWanted(int count);
    void oneMoreWanted();
    void anotherWanted();
    void facetsWanted(int faces);
    void netWanted(int faces);

private:
    QPushButton *button(const QString &text, const char *name, const QString &tip);

    int m_count = 8, m_faces = 60;
    QPushButton *m_more = nullptr, *m_another = nullptr;
};

} // namespace fff::ui
