// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/MotionStep.h>

#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CActionRobotMovement3D.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <mrpt/poses/CPosePDFGaussian.h>
#include <mrpt/poses/CPosePDFParticles.h>
#include <mrpt/poses/CPosePDFSOG.h>

#include <exception>

namespace offmap::rawlog {
namespace {

using core::PoseFault;
using mrpt::obs::CActionRobotMovement2D;

MotionStep faulty(PoseFault fault) { return {{}, {}, {}, fault}; }

MotionStep stepOf(const mrpt::poses::CPose3DPDFGaussian& pdf) {
    if (const auto fault = core::faultOf(pdf)) return faulty(*fault);
    return {{}, pdf.mean.asTPose(), triangleOf(core::groundBlock(pdf.cov)), {}};
}

/// Sets of nothing have a mean of zero in MRPT, but tell no movement.
bool isEmpty(const mrpt::poses::CPosePDF& pdf) {
    const auto* particles = dynamic_cast<const mrpt::poses::CPosePDFParticles*>(&pdf);
    const auto* modes = dynamic_cast<const mrpt::poses::CPosePDFSOG*>(&pdf);
    return (particles && particles->size() == 0) || (modes && modes->empty());
}

MotionStep stepOf(const CActionRobotMovement2D& movement) {
    if (!movement.poseChange || isEmpty(*movement.poseChange)) return faulty(PoseFault::NotFinite);
    mrpt::poses::CPosePDFGaussian gaussian;
    try {
        gaussian.copyFrom(*movement.poseChange);
    } catch (const std::exception&) {  // a density that has no mean
        return faulty(PoseFault::NotFinite);
    }
    return stepOf(mrpt::poses::CPose3DPDFGaussian(gaussian));
}

}  // namespace

std::optional<MotionStep> movementOf(const mrpt::obs::CActionCollection& actions) {
    for (const auto& action : actions) {
        const mrpt::obs::CAction* const pointer = action.get_ptr().get();
        if (const auto* plane = dynamic_cast<const CActionRobotMovement2D*>(pointer)) {
            return stepOf(*plane);
        }
        if (const auto* space = dynamic_cast<const mrpt::obs::CActionRobotMovement3D*>(pointer)) {
            return stepOf(space->poseChange);
        }
    }
    return std::nullopt;
}

}  // namespace offmap::rawlog
