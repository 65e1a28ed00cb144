// Times one predicate of CGAL's EPICK kernel over calls read from a file: a peer of `predicates_table`.
//
// Arguments: predicate (orient2d, in_circle, orient3d, in_sphere), file of doubles (three for each point), rounds.
// Prints the nanoseconds of a call, those of the second quickest round, the median and the upper quartile, and the numbers of positive and of negative answers.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

template <class Point, class Answer>
void run(const std::vector<Point>& points, std::size_t per_call, int rounds, Answer answer) {
    std::vector<double> times;
    long positive = 0, negative = 0;
    const std::size_t calls = points.size() / per_call;
    for (int round = 0; round < rounds; ++round) {
        positive = negative = 0;
        const auto start = std::chrono::steady_clock::now();
        for (std::size_t call = 0; call < calls; ++call) {
            const int sign = static_cast<int>(answer(&points[call * per_call]));
            positive += sign > 0;
            negative += sign < 0;
        }
        const std::chrono::duration<double, std::nano> elapsed = std::chrono::steady_clock::now() - start;
        times.push_back(elapsed.count() / static_cast<double>(calls));
    }
    std::sort(times.begin(), times.end());
    const std::size_t low = std::min<std::size_t>(1, times.size() - 1);
    const std::size_t high = times.size() - times.size() / 4 - 1;
    std::printf("%.2f %.2f %.2f %ld %ld\n", times[low], times[times.size() / 2], times[high], positive, negative);
}

int main(int count, char** arguments) {
    if (count != 4) return 2;
    std::FILE* file = std::fopen(arguments[2], "rb");
    if (!file) return 2;
    std::vector<Kernel::Point_2> plane;
    std::vector<Kernel::Point_3> space;
    double p[3];
    while (std::fread(p, sizeof(double), 3, file) == 3) {
        plane.emplace_back(p[0], p[1]);
        space.emplace_back(p[0], p[1], p[2]);
    }
    std::fclose(file);
    const int rounds = std::atoi(arguments[3]);
    const Kernel kernel;
    const auto is = [&](const char* name) { return std::strcmp(arguments[1], name) == 0; };
    if (is("orient2d")) {
        const auto f = kernel.orientation_2_object();
        run(plane, 3, rounds, [&](const Kernel::Point_2* p) { return f(p[0], p[1], p[2]); });
    } else if (is("in_circle")) {
        const auto f = kernel.side_of_oriented_circle_2_object();
        run(plane, 4, rounds, [&](const Kernel::Point_2* p) { return f(p[0], p[1], p[2], p[3]); });
    } else if (is("orient3d")) {
        const auto f = kernel.orientation_3_object();
        run(space, 4, rounds, [&](const Kernel::Point_3* p) { return f(p[0], p[1], p[2], p[3]); });
    } else {
        const auto f = kernel.side_of_oriented_sphere_3_object();
        run(space, 5, rounds, [&](const Kernel::Point_3* p) { return f(p[0], p[1], p[2], p[3], p[4]); });
    }
}
