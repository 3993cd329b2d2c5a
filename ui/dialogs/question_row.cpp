#include "ui/dialogs/question_row.h"

#include "ui/view/heading_weight.h"

#include <QGridLayout>
#include <QLabel>

namespace fff::ui {

namespace {

constexpr int kBadgeSize = 22; // px

} // namespace

QuestionRow::QuestionRow(const QString &question, QWidget *parent)
    : QWidget(parent), m_number(new QLabel(this)), m_answers(new QVBoxLayout)
{
    m_number->setObjectName(QStringLiteral("questionNumber")); // a disc, by the style sheet
    m_number->setAlignment(Qt::AlignCenter);
    m_number->setFixedSize(kBadgeSize, kBadgeSize);
    auto *title = new QLabel(question, this);
    QFont bold = title->font();
    bold.setWeight(headingWeight());
    title->setFont(bold);
    m_answers->setSpacing(4);
    auto *grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 10);
    grid->setHorizontalSpacing(kIndent - kBadgeSize);
    grid->setVerticalSpacing(4);
    grid->addWidget(m_number, 0, 0);
    grid->addWidget(title, 0, 1);
    grid->addLayout(m_answers, 1, 1);
    grid->setColumnStretch(1, 1);
}

void QuestionRow::add(QWidget *answer)
{
    m_answers->addWidget(answer);
}

void QuestionRow::setNumber(int number)
{
    m_number->setText(locale().toString(number));
}

void QuestionRow::number(const std::vector<QuestionRow *> &rows)
{
    int number = 0;
    for (QuestionRow *row : rows)
        if (!row->isHidden())
            row->setNumber(++number);
}

} // namespace fff::ui
