// The predicate benchmarks, one function for each source file of them.
#pragma once

namespace voroproof::internal::bench {

// The first collapse of an edge within a window, against root isolation by CGAL and Arb.
void register_flip_benchmarks();
// The in-circle predicate at one instant.
void register_incircle_benchmarks();
// The next contact of two generators.
void register_contact_benchmarks();
// The change of motion at a collision.
void register_collide_benchmarks();

}  // namespace voroproof::internal::bench
