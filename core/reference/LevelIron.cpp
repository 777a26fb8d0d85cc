#include "core/reference/LevelIron.h"

namespace lubberline {

SensorModel levelIron(const ExactSmith& smith, double horizontal_nT)
{
    SensorModel model;
    model.softIron(0, 0) = smith.D;
    model.softIron(1, 1) = -smith.D;
    model.softIron(0, 1) = smith.E - smith.A;
    model.softIron(1, 0) = smith.E + smith.A;
    model.hardIron_nT = {smith.B * horizontal_nT, smith.C * horizontal_nT, 0};
    return model;
}

} // namespace lubberline
