#include "ui/storage/Storage.h"
