#include "app/FourierMemory.h"

#include <QDir>
#include <QStandardPaths>

#include "core/iron/FourierGrid.h"

namespace lubberline::app {

namespace {

QString folder() { return QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation) + "/lubberline"; }
std::string file() { return (folder() + "/fourier-plans").toStdString(); }

} // namespace

FourierMemory::FourierMemory() { loadFourierWisdom(file()); }

FourierMemory::~FourierMemory()
{
    if (QDir().mkpath(folder()))
        saveFourierWisdom(file());
}

} // namespace lubberline::app
