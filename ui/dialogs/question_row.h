// A numbered question with what answers it below: "1 Which stock?".
#pragma once

#include <QWidget> // first: moc stumbles over some standard headers

#include <vector>

class QLabel;
class QVBoxLayout;

namespace fff::ui {

class QuestionRow : public QWidget
{
    Q_OBJECT
public:
    explicit QuestionRow(const QString &question, QWidget *parent = nullptr);

    /// Answers begin so far from the left, px.
    static constexpr int kIndent = 32;

    void add(QWidget *answer);
    void setNumber(int number);

    /// Those that are to be seen get numbers from 1 on.
    static void number(const std::vector<QuestionRow *> &rows);

private:
    QLabel *m_number = nullptr;
    QVBoxLayout *m_answers = nullptr;
};

} // namespace fff::ui
