// All of the library.
#pragma once

#include "voroproof/certify.h"
#include "voroproof/diagram.h"
#include "voroproof/error.h"
#include "voroproof/extensions.h"
#include "voroproof/free_space.h"
#include "voroproof/generators.h"
#include "voroproof/history.h"
#include "voroproof/movie.h"
#include "voroproof/number.h"
#include "voroproof/plan.h"
#include "voroproof/queries.h"
#include "voroproof/recorded_motion.h"
#include "voroproof/scene.h"
#include "voroproof/simulate.h"
#include "voroproof/static_diagram.h"
#include "voroproof/version.h"
