// Solvers of PoseLib behind the harness: `poselib CASE FILE`.
#include "harness.hpp"

#include <PoseLib/camera_pose.h>
#include <PoseLib/misc/re3q3.h>
#include <PoseLib/solvers/gen_relpose_6pt.h>
#include <PoseLib/solvers/gp4ps.h>
#include <PoseLib/solvers/p35pf.h>
#include <PoseLib/solvers/p3p.h>
#include <PoseLib/solvers/relpose_5pt.h>
#include <PoseLib/solvers/relpose_6pt_focal.h>
#include <PoseLib/solvers/relpose_kFk_9pt.h>

#include <memory>

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Vectors = std::vector<Vector3d>;

static Vectors vectors(const double *data, size_t count) {
    Vectors list;
    for (size_t k = 0; k < count; ++k) list.emplace_back(data[3 * k], data[3 * k + 1], data[3 * k + 2]);
    return list;
}

static void append(std::vector<double> &values, const Matrix3d &matrix) {
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) values.push_back(matrix(i, j));
}

// Rotation, row by row, then translation.
static void append(std::vector<double> &values, const poselib::CameraPose &pose) {
    append(values, pose.R());
    for (int i = 0; i < 3; ++i) values.push_back(pose.t(i));
}

// N lists of COUNT vectors each.
template <size_t N, size_t COUNT> struct OfVectors : Solver {
    std::vector<std::array<Vectors, N>> instances;
    void load(const double *data) override {
        std::array<Vectors, N> lists;
        for (size_t k = 0; k < N; ++k) lists[k] = vectors(data + 3 * COUNT * k, COUNT);
        instances.push_back(lists);
    }
};

struct FivePoint : OfVectors<2, 5> {
    std::vector<Matrix3d> found;
    size_t solve(size_t k) override {
        found.clear();
        return poselib::relpose_5pt(instances[k][0], instances[k][1], &found);
    }
    std::vector<double> solutions() const override {
        std::vector<double> values;
        for (const auto &matrix : found) append(values, matrix);
        return values;
    }
};

// Solvers that return poses, without more.
template <size_t N, size_t COUNT> struct Poses : OfVectors<N, COUNT> {
    poselib::CameraPoseVector found;
    std::vector<double> solutions() const override {
        std::vector<double> values;
        for (const auto &pose : found) append(values, pose);
        return values;
    }
};

struct ThreePoint : Poses<2, 3> {
    size_t solve(size_t k) override {
        found.clear();
        return poselib::p3p(instances[k][0], instances[k][1], &found);
    }
};

struct GeneralizedSixPoint : Poses<4, 6> {
    size_t solve(size_t k) override {
        found.clear();
        const auto &rays = instances[k];
        return poselib::gen_relpose_6pt(rays[0], rays[1], rays[2], rays[3], &found);
    }
};

struct GeneralizedPoseScale : OfVectors<3, 4> {
    poselib::CameraPoseVector found;
    std::vector<double> scales;
    size_t solve(size_t k) override {
        found.clear();
        scales.clear();
        return poselib::gp4ps(instances[k][0], instances[k][1], instances[k][2], &found, &scales);
    }
    std::vector<double> solutions() const override {
        std::vector<double> values;
        for (size_t k = 0; k < found.size(); ++k) {
            append(values, found[k]);
            values.push_back(scales[k]);
        }
        return values;
    }
};

struct SixPointFocal : OfVectors<2, 6> {
    poselib::ImagePairVector found;
    size_t solve(size_t k) override {
        found.clear();
        return poselib::relpose_6pt_shared_focal(instances[k][0], instances[k][1], &found);
    }
    std::vector<double> solutions() const override {
        std::vector<double> values;
        for (const auto &pair : found) {
            append(values, pair.pose);
            values.push_back(pair.camera1.focal());
        }
        return values;
    }
};

struct RadialNinePoint : OfVectors<2, 9> {
    std::vector<poselib::ProjectiveImagePair> found;
    size_t solve(size_t k) override {
        found.clear();
        return poselib::relpose_kFk_9pt(instances[k][0], instances[k][1], &found);
    }
    std::vector<double> solutions() const override {
        std::vector<double> values;
        for (const auto &pair : found) {
            append(values, pair.F);
            values.push_back(pair.camera1.params[4]);
        }
        return values;
    }
};

struct ThreeAndAHalfPoint : Solver {
    std::vector<std::pair<std::vector<Vector2d>, Vectors>> instances;
    poselib::CameraPoseVector found;
    std::vector<double> focals;
    void load(const double *data) override {
        std::vector<Vector2d> images;
        for (int k = 0; k < 4; ++k) images.emplace_back(data[2 * k], data[2 * k + 1]);
        instances.emplace_back(images, vectors(data + 8, 4));
    }
    size_t solve(size_t k) override {
        found.clear();
        focals.clear();
        return poselib::p35pf(instances[k].first, instances[k].second, &found, &focals);
    }
    std::vector<double> solutions() const override {
        std::vector<double> values;
        for (size_t k = 0; k < found.size(); ++k) {
            append(values, found[k]);
            values.push_back(focals[k]);
        }
        return values;
    }
};

struct ThreeQuadrics : Solver {
    using Coefficients = Eigen::Matrix<double, 3, 10>;
    std::vector<Coefficients, Eigen::aligned_allocator<Coefficients>> instances;
    Eigen::Matrix<double, 3, 8> found;
    size_t count = 0;
    void load(const double *data) override {
        Coefficients coefficients;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 10; ++j) coefficients(i, j) = data[10 * i + j];
        instances.push_back(coefficients);
    }
    size_t solve(size_t k) override {
        count = poselib::re3q3::re3q3(instances[k], &found);
        return count;
    }
    std::vector<double> solutions() const override {
        return std::vector<double>(found.data(), found.data() + 3 * count);
    }
};

static std::unique_ptr<Solver> solver(const std::string &name) {
    if (name == "relpose_5pt") return std::make_unique<FivePoint>();
    if (name == "relpose_6pt_focal") return std::make_unique<SixPointFocal>();
    if (name == "pose_35pt_focal") return std::make_unique<ThreeAndAHalfPoint>();
    if (name == "fundamental_8pt_radial") return std::make_unique<RadialNinePoint>();
    if (name == "relpose_6pt_generalized") return std::make_unique<GeneralizedSixPoint>();
    if (name == "pose_4pt_generalized_scale") return std::make_unique<GeneralizedPoseScale>();
    if (name == "three_quadrics") return std::make_unique<ThreeQuadrics>();
    if (name == "pose_3pt") return std::make_unique<ThreePoint>();
    return nullptr;
}

int main(int count, char **arguments) {
    if (count != 3) return 2;
    const auto chosen = solver(arguments[1]);
    return chosen ? serve(*chosen, arguments[2]) : 2;
}
