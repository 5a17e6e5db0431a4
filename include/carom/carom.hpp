// Everything that Carom offers.
#pragma once

#include <carom/body.hpp>
#include <carom/broad_phase.hpp>
#include <carom/chain.hpp>
#include <carom/character.hpp>
#include <carom/debug_draw.hpp>
#include <carom/error.hpp>
#include <carom/events.hpp>
#include <carom/fields.hpp>
#include <carom/hooks.hpp>
#include <carom/ids.hpp>
#include <carom/joint.hpp>
#include <carom/math.hpp>
#include <carom/memory.hpp>
#include <carom/profile.hpp>
#include <carom/queries.hpp>
#include <carom/report.hpp>
#include <carom/shape.hpp>
#include <carom/simd.hpp>
#include <carom/step_probe.hpp>
#include <carom/version.hpp>
#include <carom/world.hpp>
