#pragma once
/// Where models come from and go to: Model JSON files, swings, the iron bench. A model that comes is a new record.

#include <QWidget>

#include "core/swing/IronSeparation.h"
#include "db/stores/Stores.h"
#include "ui/kit/FileQuestions.h"

class QPushButton;

namespace lubberline::ui {

class SensorEditor;
class SensorFieldForm;

class SensorActions : public QWidget {
    Q_OBJECT

public:
    struct Parts {
        db::Stores& stores;
        SensorEditor& editor;
        SensorFieldForm& field;
    };
    SensorActions(const Parts& parts, FileQuestions files, QWidget* parent = nullptr);

public slots:
    void load();
    void save();
    void estimateFromNewest(lubberline::Origin origin);
    void estimateBySeparation();

signals:
    void failed(const QString& message);
    void benchWanted();

private:
    QPushButton* addButton(const QString& name, const QString& text, int row, int column);
    void addEstimates(QPushButton& button);
    void take(const Result<SensorRecord>& estimate);
    void follow();

    Parts m_parts;
    FileQuestions m_files;
    QPushButton *m_load, *m_save, *m_estimate, *m_bench;
};

} // namespace lubberline::ui
