#pragma once
/// Before the first reading: the checklist, and the compass read with engines or electrics off and on.

#include <QWidget>

#include "ui/guided/GuidedJob.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;
class QVBoxLayout;

namespace lubberline::ui {

class GuidedPrepare : public QWidget {
    Q_OBJECT

public:
    explicit GuidedPrepare(GuidedJob& job, QWidget* parent = nullptr);
    void refresh();
    void focusField();

signals:
    void failed(const QString& message);

private:
    void rebuildList();
    void showInterference();
    void takeInterference(int row);
    void goOn();
    void tell(job::What what);

    GuidedJob& m_job;
    QVBoxLayout* m_list;
    QLineEdit* m_load;
    QTableWidget* m_table;
    QLabel* m_message;
    QPushButton* m_go;
    bool m_filling = false;
    std::vector<std::string> m_listed; ///< the items that have a box
};

} // namespace lubberline::ui
